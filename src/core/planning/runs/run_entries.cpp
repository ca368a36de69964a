// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/runs/run_entries.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace lamina {
namespace {

constexpr double kSameEntry = 1e-6;  // mm

template <class Value>
AlongPath<Value> without(const AlongPath<Value>& along, std::size_t waypoint) {
  if (along.isCommon()) return along;
  std::vector<Value> values = along.values();
  values.erase(values.begin() + static_cast<std::ptrdiff_t>(waypoint));
  return AlongPath<Value>(std::move(values));
}

void removeWaypoint(Path& travel, std::size_t waypoint) {
  travel.points.erase(travel.points.begin() + static_cast<std::ptrdiff_t>(waypoint));
  travel.orientation = without(travel.orientation, waypoint);
  travel.bead = without(travel.bead, waypoint);
  travel.feed_mm_s = without(travel.feed_mm_s, waypoint);
  for (ProcessValue& value : travel.values) value.value = without(value.value, waypoint);
  for (PathEvent& placed : travel.events) placed.motion = std::min(placed.motion, travel.motionCount());
}

/// A travel that ends, or starts, elsewhere: the waypoint next to that may be there already.
void leadTo(Path& travel, std::size_t waypoint, std::size_t next, const Point3& to) {
  travel.points[waypoint] = to;
  if (travel.points.size() > 2 && (travel.points[next] - to).norm() <= kSameEntry)
    removeWaypoint(travel, next);
}

}  // namespace

Point3 entryPoint(const Point3& place, const Eigen::Quaterniond& nozzle, const EntrySettings& settings) {
  const Point3 away =
      settings.direction == EntryDirection::Level ? Point3::UnitZ() : Point3(-(nozzle * Point3::UnitZ()));
  return place + settings.distance_mm * away;
}

Path entryTravel(const Point3& from, const Point3& to, const Eigen::Quaterniond& nozzle, double feed_mm_s) {
  Path path;
  path.role = PathRole::Travel;
  path.points = {from, to};
  path.orientation = nozzle;
  path.feed_mm_s = feed_mm_s;
  return path;
}

void endAtEntry(Path& travel, const Point3& entry) {
  leadTo(travel, travel.points.size() - 1, travel.points.size() - 2, entry);
}

void startAtEntry(Path& travel, const Point3& entry) { leadTo(travel, 0, 1, entry); }

}  // namespace lamina
