// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/cooling/parking.hpp"

namespace lamina {
namespace {

constexpr double kBeside = 5.0;  // mm

/// Where the nozzle waits, at the height where it is.
Point3 parkAt(const Point3& here, const Box3& box, ParkPlace place) {
  switch (place) {
    case ParkPlace::Outside:
      return {box.low.x() - kBeside, here.y(), here.z()};
    case ParkPlace::Corner:
      return {box.low.x(), box.low.y(), here.z()};
    case ParkPlace::Stay:
      break;
  }
  return here;
}

}  // namespace

double travelFeed(const ToolpathLayer& layer) {
  for (const Path& path : layer.paths)
    if (path.role == PathRole::Travel) return path.feed_mm_s.at(0);
  return layer.paths.back().feed_mm_s.at(0);
}

Path parkedWait(const Path& at, std::size_t waypoint, double travel_feed_mm_s, const ParkingGround& ground,
                const CoolingSettings& settings) {
  const Point3 here = at.points[waypoint];
  const Point3 lift = settings.lift_mm * ground.up;
  const Point3 park = parkAt(here, ground.part, settings.park);
  Path path;
  path.role = PathRole::Travel;
  path.process.is_retracted = true;
  path.tool = at.tool;
  path.orientation = at.orientation.at(waypoint);
  path.feed_mm_s = travel_feed_mm_s;
  path.points = {here};
  if (settings.lift_mm > 0.0) path.points.push_back(here + lift);
  if (park != here) path.points.push_back(park + lift);
  path.events.emplace_back();
  path.events.back().motion = path.points.size() - 1;
  path.events.back().event.emplace<Dwell>();
  if (park != here && settings.lift_mm > 0.0) path.points.push_back(here + lift);
  path.points.push_back(here);
  return path;
}

}  // namespace lamina
