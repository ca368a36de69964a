// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/planning/runs/runs.hpp"
#include "planning/flow/path_cut.hpp"
#include "planning/runs/run_ends.hpp"
#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

constexpr double kGoldenShare = 0.6180339887498949;
constexpr double kAtWaypoint = 1e-6;  // mm: nearer to a waypoint none is added

double startShare(const StartSettings& settings, std::size_t layer) {
  const double step = settings.rule == StartRule::Golden ? kGoldenShare : 0.5;
  const double share = settings.first_share + step * static_cast<double>(layer);
  return share - std::floor(share);
}

template <class Value>
AlongPath<Value> turnedRound(const AlongPath<Value>& along, std::size_t first) {
  if (along.isCommon()) return along;
  std::vector<Value> values = along.values();
  std::rotate(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(first), values.end());
  return AlongPath<Value>(std::move(values));
}

Path startingAt(Path path, std::size_t first) {
  std::rotate(path.points.begin(), path.points.begin() + static_cast<std::ptrdiff_t>(first),
              path.points.end());
  path.orientation = turnedRound(path.orientation, first);
  path.bead = turnedRound(path.bead, first);
  path.feed_mm_s = turnedRound(path.feed_mm_s, first);
  for (ProcessValue& value : path.values) value.value = turnedRound(value.value, first);
  return path;
}

/// The closed path from a place on it on.
Path startingAlong(const Path& path, double way_mm) {
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const double length_mm = motionLength(path, m);
    if (way_mm <= kAtWaypoint) return startingAt(path, m);
    if (way_mm < length_mm - kAtWaypoint)
      return startingAt(withWaypoints(path, {{m, way_mm / length_mm}}), m + 1);
    way_mm -= length_mm;
  }
  return path;
}

bool hasEventsAmid(const Path& path) {
  return std::any_of(path.events.begin(), path.events.end(), [&](const PathEvent& placed) {
    return placed.motion > 0 && placed.motion < path.motionCount();
  });
}

}  // namespace

std::size_t spreadStarts(Toolpath& toolpath, const StartSettings& settings) {
  if (settings.rule == StartRule::Keep) return 0;
  std::size_t moved = 0;
  const std::vector<RunPlace> places = placesOf(toolpath);
  for (const RunSpan& run : runsOf(toolpath, places)) {
    Path& path = pathAt(toolpath, places[run.begin]);
    const RunTravels travels = travelsOf(toolpath, places, run);
    if (run.count() > 1 || !path.is_closed || travels.is_joined || hasEventsAmid(path)) continue;
    const NozzlePose before = startPose(path);
    path = startingAlong(path, startShare(settings, places[run.begin].layer) * length(path));
    if (travels.before != nullptr) shiftEnd(*travels.before, before, startPose(path));
    if (travels.after != nullptr) shiftStart(*travels.after, before, startPose(path));
    ++moved;
  }
  return moved;
}

}  // namespace lamina
