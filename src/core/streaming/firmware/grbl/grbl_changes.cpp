// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What a person changes while a job runs.
#include "streaming/firmware/grbl/grbl_job.hpp"

namespace lamina {

/// Overrides are made of bytes that need no room in the buffer.
std::string GrblJob::change(const LiveChange& change, double now) {
  const bool is_running =
      state() == PackmlState::Execute || state() == PackmlState::Holding || state() == PackmlState::Held;
  if (!is_running || !isRunning()) return kNoJobToChange;
  std::string refusal = overrides_.set(change, now);
  if (refusal.empty()) poll(now);
  return refusal;
}

void GrblJob::followOverrides(const GrblReport& report, double now) {
  if (report.overrides) overrides_.hear(*report.overrides, now);
  if (!overrides_.isUnderWay()) return;
  output_ += overrides_.takeBytes();
  const std::string remark = overrides_.giveUp(now);
  if (!remark.empty()) record_.status.message = remark;
}

}  // namespace lamina
