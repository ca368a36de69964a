// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A point that a robot's tip touched, in the robot's base [mm].
struct TouchedPoint {
  Point3 base = Point3::Zero();
  std::optional<Point3> object;  ///< the same point in the frame of the object, where that is known
  std::size_t line = 0;          ///< of the table that states it, from 1; 0 if none does
};

/// Position of the origin of an object that three points determine.
enum class ObjectOrigin {
  Foot,  ///< at the foot of the perpendicular from the third to the line of the others, as in RAPID
  First  ///< at the first one
};

/// The frame of an object by three touched points: from the first to the second along x, the third on the
/// side of y.
/// @throws InvalidInput if the first two are less than 1 mm apart, or the third one is less than 1 mm off
///   their line
Eigen::Isometry3d workObjectOfAxes(const std::array<Point3, 3>& points, ObjectOrigin origin);

/// The frame of an object as found from known points of it.
struct WorkObjectFit {
  Eigen::Isometry3d base_from_object = Eigen::Isometry3d::Identity();
  double rms_mm = 0.0;                ///< of the distances between points as touched and as known
  std::vector<double> distances_mm;   ///< of each point
  std::vector<std::size_t> outlying;  ///< points that contradict the others, by index; all are fitted
};

/// The pose of an object that brings its known points nearest to the touched ones, by least squares
/// [Kabsch1976].
/// @throws InvalidInput if there are fewer than three points, if one states no point of the object, or if all
///   lie on one line
WorkObjectFit fitWorkObject(const std::vector<TouchedPoint>& points);

/// Reads points from CSV, one a row, with the columns x_mm, y_mm, z_mm and, for known points of the object,
/// object_x_mm, object_y_mm, object_z_mm.
/// @param source  names the table in errors
/// @throws InvalidInput naming the line if a cell is not a number below 1e12; also if a column is missing
std::vector<TouchedPoint> touchedPointsFromCsv(std::string_view text, const std::string& source);

}  // namespace lamina
