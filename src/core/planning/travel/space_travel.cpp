// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/travel/space_travel.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>
#include <vector>

#include "geometry/space_vectors.hpp"
#include "planning/lift/held_along.hpp"
#include "planning/nozzle_frame.hpp"
#include "planning/travel/retraction.hpp"

namespace lamina {
namespace {

/// Tips nearer than this join [mm].
constexpr double kSame = 1e-6;
/// Waypoints nearer than this to the line past them are needless [mm].
constexpr double kStraight = 1e-9;

bool isBetween(const Point3& from, const Point3& point, const Point3& to) {
  const Point3 along = to - from;
  return (point - from).cross(along).norm() <= kStraight * along.norm() && (point - from).dot(along) >= 0.0 &&
         (point - to).dot(along) <= 0.0;
}

/// The way there and the way back down, without waypoints that change nothing.
class Route {
 public:
  void add(const Point3& point, const Eigen::Quaterniond& orientation) {
    const auto isHeldAlike = [&](std::size_t i) { return orientations[i].coeffs() == orientation.coeffs(); };
    if (!points.empty() && points.back() == point && isHeldAlike(points.size() - 1)) return;
    const std::size_t count = points.size();
    if (count > 1 && isHeldAlike(count - 1) && isHeldAlike(count - 2) &&
        isBetween(points[count - 2], points[count - 1], point)) {
      points.pop_back();
      orientations.pop_back();
    }
    points.push_back(point);
    orientations.push_back(orientation);
  }

  std::vector<Point3> points;
  std::vector<Eigen::Quaterniond> orientations;
};

Point3 atHeight(const Point3& point, double z) { return {point.x(), point.y(), z}; }

/// How far the straight line between two poses may lie below a layer that bends evenly between them, twice:
/// for normals an angle a apart, a distance d on the arc has a rise of d a / 8.
double riseBetween(const NozzlePose& from, const NozzlePose& to) {
  const Point3 one = againstToolAxis(from.orientation);
  const Point3 other = againstToolAxis(to.orientation);
  return 0.25 * (to.point - from.point).norm() * angleBetween(one, other);
}

Route nearby(const NozzlePose& from, const NozzlePose& to) {
  const double rise = riseBetween(from, to);
  const auto raised = [rise](const NozzlePose& pose, const NozzlePose& other) {
    const Point3 up = againstToolAxis(pose.orientation);
    return Point3(pose.point + (std::max(0.0, up.dot(other.point - pose.point)) + rise) * up);
  };
  Route route;
  route.add(from.point, from.orientation);
  route.add(raised(from, to), from.orientation);
  route.add(raised(to, from), to.orientation);
  route.add(to.point, to.orientation);
  return route;
}

Route above(const NozzlePose& from, const NozzlePose& to, double hop, double highest) {
  const Point3 off = from.point + hop * againstToolAxis(from.orientation);
  const Point3 onto = to.point + hop * againstToolAxis(to.orientation);
  const double z = std::max({highest + hop, from.point.z() + hop, to.point.z() + hop, off.z(), onto.z()});
  Route route;
  route.add(from.point, from.orientation);
  route.add(off, from.orientation);
  route.add(atHeight(off, z), from.orientation);
  route.add(atHeight(onto, z), to.orientation);
  route.add(onto, to.orientation);
  route.add(to.point, to.orientation);
  return route;
}

}  // namespace

NozzlePose startPose(const Path& path) { return {path.firstPoint(), path.orientation.at(0)}; }

NozzlePose endPose(const Path& path) {
  return {path.lastPoint(), path.orientation.at(path.is_closed ? 0 : path.points.size() - 1)};
}

std::optional<Path> makeSpaceTravel(const NozzlePose& from, const NozzlePose& to,
                                    const TravelSettings& settings, double highest_mm) {
  const double distance = (to.point - from.point).norm();
  if (distance <= kSame) return std::nullopt;
  Path path;
  path.role = PathRole::Travel;
  path.feed_mm_s = settings.feed_mm_s;
  path.process.is_retracted = isRetracted(distance, TravelOver::Anything, settings);
  Route route = path.process.is_retracted ? above(from, to, settings.hop_mm, highest_mm) : nearby(from, to);
  path.points = std::move(route.points);
  path.orientation = heldAlong(std::move(route.orientations));
  return path;
}

TravelMaker spaceTravels(const std::vector<ToolpathLayer>& layers, const TravelSettings& settings,
                         double standing_mm) {
  std::vector<double> highest;
  double z = standing_mm;
  for (const ToolpathLayer& layer : layers) {
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel)
        for (const Point3& point : path.points) z = std::max(z, point.z());
    highest.push_back(z);
  }
  return [settings, highest = std::move(highest)](const Path& from, const Path& to, std::size_t layer) {
    return makeSpaceTravel(endPose(from), startPose(to), settings, highest[layer]);
  };
}

}  // namespace lamina
