// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/cooling/parking.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "lamina/toolpath/layer_frame.hpp"
#include "planning/same_height.hpp"
#include "toolpath/layer_time.hpp"

namespace lamina {
namespace {

constexpr double kBeside = 5.0;    // mm
constexpr double kUpright = 1e-3;  // rad

/// The way out and back along the tool axis, and the wait at its end.
void waitAlong(const Point3& against_tool_axis, double lift_mm, Path& path) {
  const Point3 here = path.points.front();
  path.points.push_back(here + lift_mm * against_tool_axis);
  path.events.back().motion = path.points.size() - 1;
  path.points.push_back(here);
}

bool leansFrom(const Point3& up, const Path& path) {
  return (path.orientation.at(0) * Point3::UnitZ()).cross(up).norm() > kUpright;
}

/// Whether a wait can go straight on to the next bead.
bool canLeadOn(const Path& wait, const std::vector<Path>& way, const Path& next, const Point3& up) {
  const Point3& parked = wait.points[wait.events.front().motion];
  if (leansFrom(up, wait) || next.tool != wait.tool) return false;
  if (wait.orientation.at(0).angularDistance(next.orientation.at(0)) > kUpright) return false;
  if ((parked - next.firstPoint()).dot(up) < 0.0) return false;
  return std::all_of(way.begin(), way.end(), [&wait](const Path& travel) {
    return travel.tool == wait.tool && travel.events.empty() && travel.orientation.isCommon();
  });
}

/// Speed of a layer's travels [mm/s]; 0 if it has none.
double ownTravelFeed(const ToolpathLayer& layer) {
  double greatest_mm_s = 0.0;  // others are ends of runs
  for (const Path& path : layer.paths)
    if (path.role == PathRole::Travel) greatest_mm_s = std::max(greatest_mm_s, path.feed_mm_s.at(0));
  return greatest_mm_s;
}

/// Speeds of the travels of each layer [mm/s]. The first layer of an inclined part is often a single bead:
/// there, too, the nozzle goes as fast as it travels elsewhere.
std::vector<double> travelFeeds(const std::vector<ToolpathLayer>& layers) {
  double last_mm_s = 0.0;
  for (std::size_t l = 0; l < layers.size() && last_mm_s == 0.0; ++l) last_mm_s = ownTravelFeed(layers[l]);
  std::vector<double> feeds_mm_s;
  feeds_mm_s.reserve(layers.size());
  for (const ToolpathLayer& layer : layers) {
    if (const double own_mm_s = ownTravelFeed(layer); own_mm_s > 0.0) last_mm_s = own_mm_s;
    const bool goes_at_bead = last_mm_s == 0.0 && !layer.paths.empty();
    feeds_mm_s.push_back(goes_at_bead ? layer.paths.back().feed_mm_s.at(0) : last_mm_s);
  }
  return feeds_mm_s;
}

/// Of travels without dwells.
double timeOf(std::vector<Path> paths, const MotionLimits& limits) {
  for (Path& path : paths) path.events.clear();
  return layerTime({0.0, 0.0, std::move(paths)}, limits);
}

}  // namespace

Point3 parkingPlace(const Point3& here, const Box3& box, ParkPlace place, const Point3& up) {
  if (place == ParkPlace::Stay) return here;
  const bool is_level = up.cross(Point3::UnitZ()).norm() <= kUpright;
  Point3 park = here;
  park.x() = place == ParkPlace::Outside ? box.low.x() - kBeside : box.low.x();
  if (place == ParkPlace::Corner && is_level) park.y() = box.low.y();
  if (!is_level) park.z() += std::max(0.0, (here - park).dot(up)) / up.z();
  return park;
}

std::vector<ParkingGround> parkingGrounds(const Toolpath& toolpath) {
  std::vector<ParkingGround> grounds;
  grounds.reserve(toolpath.layers.size());
  const std::vector<double> feeds_mm_s = travelFeeds(toolpath.layers);
  ParkingGround ground{depositionBox(toolpath), layerNormal(toolpath)};
  for (const ToolpathLayer& layer : toolpath.layers) {
    ground.travel_mm_s = feeds_mm_s[grounds.size()];
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
  const Point3 park = parkingPlace(here, ground.part, settings.park, ground.up);
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
  if (leansFrom(ground.up, path)) {
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

void leadOn(Path& wait, std::vector<Path>& way, const Path& next, const ParkingGround& ground,
            const MotionLimits& limits) {
  if (way.empty()) return;
  if (!canLeadOn(wait, way, next, ground.up)) {
    for (Path& travel : way) travel.process.is_retracted = true;
    return;
  }
  const double before_s = timeOf({wait}, limits) + timeOf(way, limits);
  const std::size_t parked = wait.events.front().motion;
  const Point3& end = next.firstPoint();
  const Point3 above = end + (wait.points[parked] - end).dot(ground.up) * ground.up;
  wait.points.resize(parked + 1);
  if (wait.points.back() != above) wait.points.push_back(above);
  wait.points.push_back(end);
  way.clear();
  if (auto* const dwell = std::get_if<Dwell>(&wait.events.front().event))
    dwell->duration_s = std::max(0.0, dwell->duration_s + before_s - timeOf({wait}, limits));
}

}  // namespace lamina
