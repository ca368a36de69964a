// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/work_object.hpp"

#include <cmath>

#include "base/dense_solvers.hpp"
#include "closest_rotation.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "outlying.hpp"
#include "recording_table.hpp"
#include "table_pose.hpp"

namespace lamina {
namespace {

constexpr double kLeastWay = 1.0;  // mm, between points that determine a direction
constexpr std::size_t kFewestPoints = 3;

/// Middles of the points as known and as touched, and what goes from one to the other.
struct PointSums {
  Point3 object = Point3::Zero();
  Point3 base = Point3::Zero();
  Eigen::Matrix3d product = Eigen::Matrix3d::Zero();  // touched times known, without their middles
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();   // known times known [mm²], over the number of points
};

PointSums sumsOf(const std::vector<TouchedPoint>& points) {
  PointSums sums;
  const auto count = static_cast<double>(points.size());
  for (const TouchedPoint& point : points) {
    sums.object += *point.object / count;
    sums.base += point.base / count;
  }
  for (const TouchedPoint& point : points) {
    const Point3 known = *point.object - sums.object;
    sums.product += (point.base - sums.base) * known.transpose();
    sums.spread += known * known.transpose() / count;
  }
  return sums;
}

Eigen::Isometry3d objectFittedTo(const std::vector<TouchedPoint>& points) {
  const PointSums sums = sumsOf(points);
  const double width_mm = std::sqrt(singularParts(sums.spread).values[1]);
  if (!(width_mm >= kLeastWay))
    throw InvalidInput("the known points lie within " + numberText(width_mm) +
                       " mm of one line; expected at least 1 mm: the turn about that line cannot be found");
  Eigen::Isometry3d base_from_object = Eigen::Isometry3d::Identity();
  base_from_object.linear() = closestRotation(sums.product).rotation;
  base_from_object.translation() = sums.base - base_from_object.linear() * sums.object;
  return base_from_object;
}

std::vector<double> objectDistances(const Eigen::Isometry3d& base_from_object,
                                    const std::vector<TouchedPoint>& points) {
  std::vector<double> distances;
  distances.reserve(points.size());
  for (const TouchedPoint& point : points)
    distances.push_back((base_from_object * *point.object - point.base).norm());
  return distances;
}

}  // namespace

Eigen::Isometry3d workObjectOfAxes(const std::array<Point3, 3>& points, ObjectOrigin origin) {
  const Point3 along = points[1] - points[0];
  if (!(along.norm() >= kLeastWay))
    throw InvalidInput("the points on x are " + numberText(along.norm()) +
                       " mm apart; expected at least 1 mm, and better hundreds");
  const Point3 x = along.normalized();
  const Point3 foot = points[0] + x * x.dot(points[2] - points[0]);
  const Point3 off = points[2] - foot;
  if (!(off.norm() >= kLeastWay))
    throw InvalidInput(
        "the point on the side of y is " + numberText(off.norm()) +
        " mm off the line through the points on x; expected at least 1 mm, and better hundreds");
  const Point3 y = off.normalized();
  Eigen::Isometry3d base_from_object = Eigen::Isometry3d::Identity();
  base_from_object.linear() << x, y, x.cross(y);
  base_from_object.translation() = origin == ObjectOrigin::Foot ? foot : points[0];
  return base_from_object;
}

WorkObjectFit fitWorkObject(const std::vector<TouchedPoint>& points) {
  if (points.size() < kFewestPoints)
    throw InvalidInput("the object is touched at " + std::to_string(points.size()) +
                       " points; expected at least 3");
  for (const TouchedPoint& point : points)
    if (!point.object)
      throw InvalidInput("the point of line " + std::to_string(point.line) +
                         " states no point of the object; expected object_x_mm, object_y_mm, object_z_mm");
  WorkObjectFit fit;
  fit.base_from_object = objectFittedTo(points);
  fit.distances_mm = objectDistances(fit.base_from_object, points);
  fit.rms_mm = meanDistance(fit.distances_mm);
  fit.outlying = outlyingTouches(points.size(), [&](const std::vector<std::size_t>& kept) {
    return objectDistances(objectFittedTo(pickedFrom(points, kept)), points);
  });
  return fit;
}

std::vector<TouchedPoint> touchedPointsFromCsv(std::string_view text, const std::string& source) {
  const RecordingTable table = parseRecordingTable(text, source);
  const bool is_known = findColumn(table, "object_x_mm") < table.columns.size();
  std::vector<TouchedPoint> points;
  points.reserve(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    TouchedPoint point{tablePoint(table, row, ""), std::nullopt, table.lines[row]};
    if (is_known) point.object = tablePoint(table, row, "object_");
    points.push_back(std::move(point));
  }
  return points;
}

}  // namespace lamina
