// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/calibration/external_axis_fit.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "base/dense_solvers.hpp"
#include "closest_rotation.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "outlying.hpp"
#include "recording_table.hpp"
#include "table_pose.hpp"

namespace lamina {
namespace {

constexpr std::size_t kFewestTouches = 3;
constexpr double kLeastSpan = 1.0;      // mm, of touches
constexpr double kLeastFollowed = 0.5;  // of the way of a rail
constexpr double kTurningUnknowns = 7.0;
constexpr double kRailUnknowns = 5.0;

/// A circle that is passed at known angles: its frame, x where the axis is at 0, z along the axis.
struct PassedCircle {
  Point3 centre = Point3::Zero();
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  double radius_mm = 0.0;
};

Point3 onUnitCircle(const AxisTouch& touch) {
  const double angle = toRadians(touch.value);
  return {std::cos(angle), std::sin(angle), 0.0};
}

void requireEnough(const std::vector<AxisTouch>& touches, const std::string& what) {
  if (touches.size() >= kFewestTouches) return;
  throw InvalidInput("the mark is touched at " + std::to_string(touches.size()) + " values of the " + what +
                     "; expected at least 3");
}

PassedCircle circleFittedTo(const std::vector<AxisTouch>& touches) {
  requireEnough(touches, "positioner");
  const auto count = static_cast<double>(touches.size());
  Point3 middle = Point3::Zero();
  Point3 unit_middle = Point3::Zero();
  for (const AxisTouch& touch : touches) {
    middle += touch.base / count;
    unit_middle += onUnitCircle(touch) / count;
  }
  Eigen::Matrix3d product = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  double squared = 0.0;
  for (const AxisTouch& touch : touches) {
    const Point3 unit = onUnitCircle(touch) - unit_middle;
    product += (touch.base - middle) * unit.transpose();
    spread += unit * unit.transpose() / count;
    squared += unit.squaredNorm();
  }
  const ClosestRotation closest = closestRotation(product);
  PassedCircle circle;
  circle.turn = closest.rotation;
  circle.radius_mm = squared > 0.0 ? closest.trace / squared : 0.0;
  circle.centre = middle - circle.radius_mm * (circle.turn * unit_middle);
  const double width_mm = circle.radius_mm * std::sqrt(singularParts(spread).values[1]);
  if (!(width_mm >= kLeastSpan))
    throw InvalidInput(
        "the touches on the plate lie within " + numberText(width_mm) +
        " mm of one line; expected at least 1 mm: farther from the axis, or over a wider angle");
  return circle;
}

std::vector<double> circleDistances(const PassedCircle& circle, const std::vector<AxisTouch>& touches) {
  std::vector<double> distances;
  distances.reserve(touches.size());
  for (const AxisTouch& touch : touches)
    distances.push_back(
        (circle.centre + circle.radius_mm * (circle.turn * onUnitCircle(touch)) - touch.base).norm());
  return distances;
}

/// Spreads of direction and centre in the frame of the circle, from the scatter of the touches through the
/// equations of small changes: place, turns about x, y, z (as ways on the circle) and radius.
void stateSpreads(TurningAxisFit& fit, const std::vector<AxisTouch>& touches) {
  Eigen::MatrixXd changes(3 * static_cast<Eigen::Index>(touches.size()), 7);
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const auto row = 3 * static_cast<Eigen::Index>(i);
    const Point3 unit = onUnitCircle(touches[i]);
    changes.block<3, 3>(row, 0).setIdentity();
    for (int k = 0; k < 3; ++k) changes.block<3, 1>(row, 3 + k) = Point3::Unit(k).cross(unit);
    changes.block<3, 1>(row, 6) = unit;
  }
  const SingularParts parts = singularParts(changes);
  const Eigen::MatrixXd spread = parts.right * parts.values.cwiseInverse().asDiagonal();
  const Eigen::VectorXd deviations =
      coordinateDeviation(fit.distances_mm, kTurningUnknowns) * spread.rowwise().norm();
  fit.direction_spread_deg = toDegrees(std::hypot(deviations[3], deviations[4]) / fit.radius_mm);
  fit.centre_spread_mm = std::hypot(deviations[0], deviations[1]);
}

/// A line that is passed with known values.
struct PassedLine {
  Point3 at_zero = Point3::Zero();
  Point3 direction = Point3::UnitX();  ///< of unit length
  double way_per_value = 0.0;
  double span_mm = 0.0;  ///< root of the summed squares of values over their middle
};

PassedLine lineFittedTo(const std::vector<AxisTouch>& touches) {
  requireEnough(touches, "rail");
  const auto count = static_cast<double>(touches.size());
  Point3 middle = Point3::Zero();
  double middle_value = 0.0;
  for (const AxisTouch& touch : touches) {
    middle += touch.base / count;
    middle_value += touch.value / count;
  }
  Point3 product = Point3::Zero();
  double squared = 0.0;
  for (const AxisTouch& touch : touches) {
    product += (touch.value - middle_value) * (touch.base - middle);
    squared += (touch.value - middle_value) * (touch.value - middle_value);
  }
  PassedLine line;
  line.span_mm = std::sqrt(squared);
  if (!(line.span_mm >= kLeastSpan))
    throw InvalidInput("the values of the rail span " + numberText(line.span_mm) +
                       " mm; expected at least 1 mm, and better metres");
  line.way_per_value = product.norm() / squared;
  if (!(line.way_per_value >= kLeastFollowed))
    throw InvalidInput("the mark moves by " + numberText(line.way_per_value) +
                       " mm for each millimetre of the rail; expected about 1: its coordinates must be over "
                       "the robot's base, which the rail carries");
  line.direction = product.normalized();
  line.at_zero = middle - middle_value * line.direction;
  return line;
}

std::vector<double> lineDistances(const PassedLine& line, const std::vector<AxisTouch>& touches) {
  std::vector<double> distances;
  distances.reserve(touches.size());
  for (const AxisTouch& touch : touches)
    distances.push_back((line.at_zero + touch.value * line.direction - touch.base).norm());
  return distances;
}

}  // namespace

TurningAxisFit fitTurningAxis(const std::vector<AxisTouch>& touches) {
  const PassedCircle circle = circleFittedTo(touches);
  TurningAxisFit fit;
  fit.direction = circle.turn.col(2);
  fit.centre = circle.centre;
  fit.radius_mm = circle.radius_mm;
  fit.distances_mm = circleDistances(circle, touches);
  fit.rms_mm = meanDistance(fit.distances_mm);
  stateSpreads(fit, touches);
  fit.outlying = outlyingTouches(touches.size(), [&](const std::vector<std::size_t>& kept) {
    return circleDistances(circleFittedTo(pickedFrom(touches, kept)), touches);
  });
  return fit;
}

RailFit fitRail(const std::vector<AxisTouch>& touches) {
  const PassedLine line = lineFittedTo(touches);
  RailFit fit;
  fit.direction = -line.direction;
  fit.way_per_value = line.way_per_value;
  fit.distances_mm = lineDistances(line, touches);
  fit.rms_mm = meanDistance(fit.distances_mm);
  fit.direction_spread_deg =
      toDegrees(std::sqrt(2.0) * coordinateDeviation(fit.distances_mm, kRailUnknowns) / line.span_mm);
  fit.outlying = outlyingTouches(touches.size(), [&](const std::vector<std::size_t>& kept) {
    return lineDistances(lineFittedTo(pickedFrom(touches, kept)), touches);
  });
  return fit;
}

std::vector<AxisTouch> axisTouchesFromCsv(std::string_view text, const std::string& value,
                                          const std::string& source) {
  const RecordingTable table = parseRecordingTable(text, source);
  const std::size_t column = requireColumn(table, value);
  std::vector<AxisTouch> touches;
  touches.reserve(table.rows());
  for (std::size_t row = 0; row < table.rows(); ++row)
    touches.push_back({table.at(row, column), tablePoint(table, row, ""), table.lines[row]});
  return touches;
}

}  // namespace lamina
