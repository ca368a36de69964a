// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/annotations/progress_marks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/program/gcode/gcode_dialect.hpp"
#include "lamina/toolpath/timing.hpp"

namespace lamina {
namespace {

constexpr int kParts = 100;

MachineCode mark(const std::string& words, int percent, double total_s) {
  const double left_s = total_s * (kParts - percent) / kParts;
  MachineCode code;
  code.text = dialectLine(words, {{"percent", percent}, {"minutes", std::llround(left_s / 60.0)}});
  return code;
}

void addBefore(Path& path, std::size_t motion, MachineCode code) {
  PathEvent placed;
  placed.motion = motion;
  placed.event.emplace<MachineCode>(std::move(code));
  const auto later =
      std::upper_bound(path.events.begin(), path.events.end(), motion,
                       [](std::size_t at, const PathEvent& event) { return at < event.motion; });
  path.events.insert(later, std::move(placed));
}

}  // namespace

void addProgressMarks(Toolpath& toolpath, const std::string& dialect, const MotionLimits& limits) {
  const std::string words = gcodeDialects().find(dialect).progress;
  if (words.empty())
    throw InvalidConfig("program.progress is true with program.dialect '" + dialect +
                        "', which has no word for it; expected false");
  const double total_s = estimateTime(toolpath, limits).total_s;
  if (total_s <= 0.0) return;
  std::vector<WaypointIndex> at;
  at.reserve(kParts);
  ToolpathPlayer player(toolpath, limits);
  for (int percent = 0; percent < kParts; ++percent)
    at.push_back(player.at(total_s * percent / kParts).heading_for);
  for (int percent = 0; percent < kParts; ++percent) {
    const WaypointIndex& heading = at[static_cast<std::size_t>(percent)];
    Path& path = toolpath.layers[heading.layer].paths[heading.path];
    const std::size_t motion = (heading.waypoint == 0 ? path.points.size() : heading.waypoint) - 1;
    addBefore(path, motion, mark(words, percent, total_s));
  }
  toolpath.events_at_end.emplace_back(mark(words, kParts, total_s));
}

}  // namespace lamina
