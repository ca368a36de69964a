// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/cooling/parking.hpp"

#include <algorithm>

#include "lamina/toolpath/layer_frame.hpp"

namespace lamina {
namespace {

constexpr double kBeside = 5.0;       // mm
constexpr double kSameHeight = 1e-6;  // mm
constexpr double kUpright = 1e-3;     // rad

/// The way out and back along the tool axis, and the wait at its end.
void waitAlong(const Point3& against_tool_axis, double lift_mm, Path& path) {
  const Point3 here = path.points.front();
  path.points.push_back(here + lift_mm * against_tool_axis);
  path.events.back().motion = path.points.size() - 1;
  path.points.push_back(here);
}

}  // namespace

Point3 parkingPlace(const Point3& here, const Box3& box, ParkPlace place) {
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

double travelFeed(const ToolpathLayer& layer) {
  double greatest_mm_s = 0.0;  // others are ends of runs
  for (const Path& path : layer.paths)
    if (path.role == PathRole::Travel) greatest_mm_s = std::max(greatest_mm_s, path.feed_mm_s.at(0));
  return greatest_mm_s > 0.0 ? greatest_mm_s : layer.paths.back().feed_mm_s.at(0);
}

std::vector<ParkingGround> parkingGrounds(const Toolpath& toolpath) {
  std::vector<ParkingGround> grounds;
  grounds.reserve(toolpath.layers.size());
  ParkingGround ground{depositionBox(toolpath), layerNormal(toolpath)};
  for (const ToolpathLayer& layer : toolpath.layers) {
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel)
        for (const Point3& point : path.points)
          ground.highest_mm = std::max(ground.highest_mm, point.dot(ground.up));
    grounds.push_back(ground);
  }
  return grounds;
}

Path parkedWait(const Path& at, std::size_t waypoint, double travel_feed_mm_s, const ParkingGround& ground,
                const CoolingSettings& settings) {
  const Point3 here = at.points[waypoint];
  const double above_mm = ground.highest_mm - here.dot(ground.up);
  const double lift_mm = settings.lift_mm + (above_mm > kSameHeight ? above_mm : 0.0);
  const Point3 lift = lift_mm * ground.up;
  const Point3 park = parkingPlace(here, ground.part, settings.park);
  Path path;
  path.role = PathRole::Travel;
  path.process.is_retracted = true;
  path.tool = at.tool;
  path.orientation = at.orientation.at(waypoint);
  path.feed_mm_s = travel_feed_mm_s;
  path.points = {here};
  path.events.emplace_back();
  path.events.back().event.emplace<Dwell>();
  const Point3 against = path.orientation.at(0) * Point3(0.0, 0.0, -1.0);
  if (against.cross(ground.up).norm() > kUpright) {
    waitAlong(against, std::max(settings.lift_mm, kBeside), path);
    return path;
  }
  if (lift_mm > 0.0) path.points.push_back(here + lift);
  if (park != here) path.points.push_back(park + lift);
  path.events.back().motion = path.points.size() - 1;
  if (park != here && lift_mm > 0.0) path.points.push_back(here + lift);
  path.points.push_back(here);
  return path;
}

}  // namespace lamina
