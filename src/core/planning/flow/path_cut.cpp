// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/flow/path_cut.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "toolpath/path_motions.hpp"

namespace lamina {
namespace {

/// Which waypoint of the path before each waypoint of a new one takes its quantities from.
using Sources = std::vector<std::size_t>;

/// Role, process and quantities of a path, with other points.
Path alike(const Path& path, std::vector<Point3> points, const Sources& sources) {
  Path made;
  made.role = path.role;
  made.is_closed = path.is_closed;
  made.deposit = path.deposit;
  made.process = path.process;
  made.tool = path.tool;
  made.points = std::move(points);
  made.orientation = picked(path.orientation, sources);
  made.bead = picked(path.bead, sources);
  made.feed_mm_s = picked(path.feed_mm_s, sources);
  for (const ProcessValue& value : path.values)
    made.values.push_back({value.name, picked(value.value, sources)});
  return made;
}

/// Turned evenly on the way to an added waypoint, where the nozzle turns at all.
AlongPath<Eigen::Quaterniond> turnedEvenly(const Path& path, const Sources& sources,
                                           const std::vector<CutPlace>& places) {
  if (path.orientation.isCommon()) return path.orientation;
  std::vector<Eigen::Quaterniond> held;
  std::size_t next = 0;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    held.push_back(path.orientation.at(sources[i]));
    // Added waypoints come before the one that their motion ends at, and take after it.
    const bool is_added = next < places.size() && i == places[next].motion + 1 + next;
    if (!is_added) continue;
    const CutPlace& place = places[next++];
    held.back() = path.orientation.at(place.motion).slerp(place.share, held.back());
  }
  return AlongPath<Eigen::Quaterniond>(std::move(held));
}

}  // namespace

Path withWaypoints(const Path& path, const std::vector<CutPlace>& places) {
  if (places.empty()) return path;
  std::vector<Point3> points = {path.points.front()};
  Sources sources = {0};
  std::size_t next = 0;
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const std::size_t end = path.motionEnd(m);
    for (; next < places.size() && places[next].motion == m; ++next) {
      points.emplace_back(path.points[m] + places[next].share * (path.points[end] - path.points[m]));
      sources.push_back(end);
    }
    if (end == 0) break;
    points.push_back(path.points[end]);
    sources.push_back(end);
  }
  Path made = alike(path, std::move(points), sources);
  made.orientation = turnedEvenly(path, sources, places);
  made.events = path.events;
  for (PathEvent& placed : made.events)
    placed.motion += static_cast<std::size_t>(
        std::count_if(places.begin(), places.end(),
                      [&placed](const CutPlace& place) { return place.motion < placed.motion; }));
  return made;
}

std::pair<Path, Path> cutAt(const Path& path, std::size_t waypoint) {
  Sources head;
  for (std::size_t i = 0; i <= waypoint; ++i) head.push_back(i);
  Sources tail;
  for (std::size_t i = waypoint; i < path.points.size(); ++i) tail.push_back(i);
  if (path.is_closed) tail.push_back(0);
  const auto part = [&path](const Sources& sources) {
    std::vector<Point3> points;
    for (const std::size_t i : sources) points.push_back(path.points[i]);
    Path made = alike(path, std::move(points), sources);
    made.is_closed = false;
    return made;
  };
  std::pair<Path, Path> parts{part(head), part(tail)};
  for (const PathEvent& placed : path.events) {
    const bool is_behind = placed.motion >= waypoint;
    (is_behind ? parts.second : parts.first).events.push_back(placed);
    if (is_behind) parts.second.events.back().motion -= waypoint;
  }
  return parts;
}

}  // namespace lamina
