// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/alarm_sources.hpp"

#include <algorithm>
#include <utility>

namespace lamina {

void AlarmSources::raise(ReportedCause cause) {
  end(cause.id, cause.source);
  causes_.push_back(std::move(cause));
}

std::optional<AlarmSources::End> AlarmSources::end(int id, const std::string& source) {
  const auto gone = std::find_if(causes_.begin(), causes_.end(), [&](const ReportedCause& cause) {
    return cause.id == id && cause.source == source;
  });
  if (gone == causes_.end()) return std::nullopt;
  const auto isOfAlarm = [id](const ReportedCause& cause) { return cause.id == id; };
  const bool was_shown = std::none_of(std::next(gone), causes_.end(), isOfAlarm);
  causes_.erase(gone);
  const auto other = std::find_if(causes_.rbegin(), causes_.rend(), isOfAlarm);
  if (other == causes_.rend()) return End{true, std::nullopt};
  return End{false, was_shown ? std::optional<ReportedCause>(*other) : std::nullopt};
}

bool AlarmSources::isRaised(int id) const {
  return std::any_of(causes_.begin(), causes_.end(),
                     [id](const ReportedCause& cause) { return cause.id == id; });
}

}  // namespace lamina
