// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/toolpath_event.hpp"
#include "lamina/base/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace lamina {
namespace {

bool isOneLine(const std::string& text) {
  return std::none_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < ' '; });
}

std::string defectIn(const Dwell& dwell) {
  if (dwell.duration_s >= 0.0 && std::isfinite(dwell.duration_s)) return {};
  return "dwell is " + numberText(dwell.duration_s) + " s; must be 0 or more";
}

std::string defectIn(const FanShare& fan) {
  if (fan.share >= 0.0 && fan.share <= 1.0) return {};
  return "fan share is " + numberText(fan.share) + "; must lie in 0 to 1";
}

std::string defectIn(const OperatorPause& pause) {
  return isOneLine(pause.message) ? "" : "message of a pause has a control character; must be one line";
}

std::string defectIn(const MachineCode& code) {
  const auto isAllowed = [](char c) {
    return c == '\n' || c == '\t' || static_cast<unsigned char>(c) >= ' ';
  };
  if (!code.text.empty() && std::all_of(code.text.begin(), code.text.end(), isAllowed)) return {};
  return code.text.empty() ? "code is empty; expected a line at least"
                           : "code has a control character; expected lines of text";
}

std::string defectIn(const PartMark& mark) {
  return isOneLine(mark.name) ? "" : "name of a part has a control character; must be one line";
}

}  // namespace

const char* nameOf(const ToolpathEvent& event) {
  constexpr std::array<const char*, 5> kNames = {"dwell", "fan", "pause", "code", "part"};
  return kNames.at(event.index());
}

EventRange eventsBefore(const std::vector<PathEvent>& events, std::size_t motion) {
  const auto begin =
      std::lower_bound(events.begin(), events.end(), motion,
                       [](const PathEvent& placed, std::size_t wanted) { return placed.motion < wanted; });
  const auto end =
      std::upper_bound(begin, events.end(), motion,
                       [](std::size_t wanted, const PathEvent& placed) { return wanted < placed.motion; });
  return {begin, end};
}

double dwellBefore(const std::vector<PathEvent>& events, std::size_t motion) {
  double sum_s = 0.0;
  for (const PathEvent& placed : eventsBefore(events, motion))
    if (const auto* const dwell = std::get_if<Dwell>(&placed.event)) sum_s += dwell->duration_s;
  return sum_s;
}

std::string defectOf(const ToolpathEvent& event) {
  return std::visit([](const auto& kind) { return defectIn(kind); }, event);
}

}  // namespace lamina
