// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/planning/runs/runs.hpp"
#include "planning/flow/path_cut.hpp"
#include "planning/runs/run_ends.hpp"
#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

constexpr std::size_t kOverlapSteps = 16;
constexpr double kOverlapEnd = 1e-9;  // mm
constexpr double kMostGap = 0.1;      // of a closed run; a shorter run stays closed

/// Places at equal ways along the first `way_mm` of a path.
std::vector<CutPlace> stepsAlong(const Path& path, double way_mm) {
  std::vector<CutPlace> places;
  double begin_mm = 0.0;
  std::size_t step = 1;
  for (std::size_t m = 0; m < path.motionCount() && step <= kOverlapSteps; ++m) {
    const double length_mm = motionLength(path, m);
    for (; step <= kOverlapSteps; ++step) {
      const double at_mm = way_mm * static_cast<double>(step) / kOverlapSteps;
      if (at_mm >= begin_mm + length_mm - kOverlapEnd) break;
      if (at_mm > begin_mm + kOverlapEnd) places.push_back({m, (at_mm - begin_mm) / length_mm});
    }
    begin_mm += length_mm;
  }
  return places;
}

template <class Value>
AlongPath<Value> overlapped(const AlongPath<Value>& along, std::size_t waypoints, std::size_t repeated) {
  if (along.isCommon()) return along;
  std::vector<Value> values = along.values();
  for (std::size_t i = 0; i <= repeated; ++i) values.push_back(along.at(i % waypoints));
  return AlongPath<Value>(std::move(values));
}

Path overlapping(const Path& closed, double way_mm) {
  const Path path = withWaypoints(closed, stepsAlong(closed, way_mm));
  const std::size_t waypoints = path.points.size();
  Path open = path;
  open.is_closed = false;
  std::size_t repeated = 0;
  double begin_mm = 0.0;
  std::vector<Bead> beads;
  for (std::size_t i = 0; i < waypoints; ++i) beads.push_back(path.bead.at(i));
  beads.push_back(path.bead.at(0));
  open.points.push_back(path.points.front());
  while (begin_mm < way_mm - kOverlapEnd) {
    const double length_mm = motionLength(path, repeated);
    const double share = (begin_mm + 0.5 * length_mm) / way_mm;
    const std::size_t end = path.motionEnd(repeated);
    const Bead whole = path.bead.at(end);
    beads[repeated + 1] = beadOfArea(share * crossSection(whole), whole.height_mm);
    beads.push_back(beadOfArea((1.0 - share) * crossSection(whole), whole.height_mm));
    open.points.push_back(path.points[end]);
    begin_mm += length_mm;
    ++repeated;
  }
  open.bead = AlongPath<Bead>(std::move(beads));
  open.orientation = overlapped(path.orientation, waypoints, repeated);
  open.feed_mm_s = overlapped(path.feed_mm_s, waypoints, repeated);
  for (ProcessValue& value : open.values) value.value = overlapped(value.value, waypoints, repeated);
  for (PathEvent& placed : open.events)
    if (placed.motion == path.motionCount()) placed.motion = open.motionCount();
  return open;
}

/// The place so far from the end of a path.
CutPlace placeBeforeEnd(const Path& path, double way_mm) {
  std::size_t motion = path.motionCount() - 1;
  for (; motion > 0 && motionLength(path, motion) <= way_mm + kOverlapEnd; --motion)
    way_mm -= motionLength(path, motion);
  return {motion, 1.0 - way_mm / motionLength(path, motion)};
}

/// The path without its end; events there come at the new one.
Path endedEarly(const Path& closed, double gap_mm) {
  const CutPlace end = placeBeforeEnd(closed, gap_mm);
  auto [run, rest] = cutAt(withWaypoints(closed, {end}), end.motion + 1);
  for (PathEvent& placed : rest.events) {
    placed.motion = run.motionCount();
    run.events.push_back(std::move(placed));
  }
  return std::move(run);
}

/// @throws InvalidInput if the overlap is as long as the run
Path closedBy(const Path& path, double overlap_mm, const std::string& place) {
  const double whole_mm = length(path);
  if (overlap_mm < 0.0) return -overlap_mm < kMostGap * whole_mm ? endedEarly(path, -overlap_mm) : path;
  if (overlap_mm < whole_mm) return overlapping(path, overlap_mm);
  throw InvalidInput(place + ": lead.overlap_mm is " + numberText(overlap_mm) +
                     " mm; must be less than the closed run, " + numberText(whole_mm) + " mm");
}

}  // namespace

std::size_t overlapEnds(Toolpath& toolpath, const LeadSettings& settings) {
  if (settings.overlap_mm == 0.0) return 0;
  std::size_t count = 0;
  const std::vector<RunPlace> places = placesOf(toolpath);
  for (const RunSpan& run : runsOf(toolpath, places)) {
    const RunPlace& place = places[run.begin];
    Path& path = pathAt(toolpath, place);
    const RunTravels travels = travelsOf(toolpath, places, run);
    if (run.count() > 1 || !path.is_closed || travels.is_joined) continue;
    const NozzlePose before = endPose(path);
    path = closedBy(path, settings.overlap_mm, placeText(toolpath, place));
    if (path.is_closed) continue;
    if (travels.after != nullptr) shiftStart(*travels.after, before, endPose(path));
    ++count;
  }
  return count;
}

}  // namespace lamina
