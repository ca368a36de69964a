// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/geometry/vector.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// How a row of the coordinate matrix is reached.
enum class CoordinateFlag : std::int8_t {
  Cut = -1,      ///< extruding; the trajectory is cut here: last point of a sweep and first of the next
  Start = 0,     ///< without extruding: first point of a trajectory
  Continue = 1,  ///< extruding
};

/// A row of the coordinate matrix of DECODE [Vega2023, section 3.2.3]: a point of a trajectory.
struct CoordinateRow {
  Point3 point = Point3::Zero();  ///< nozzle tip [mm]
  CoordinateFlag flag = CoordinateFlag::Start;
  double filament_mm = 0.0;  ///< pushed forth since the trajectory began: column E
};

/// Low corner of the centre lines in x and y [mm], where the matrix puts the part.
inline constexpr double kMatrixCorner = 2.0;

/// Every trajectory that lays material of the part, in order: a path of the toolpath with its first point
/// first, a closed one with that point again at its end. Skirts and supports are left out, and so is travel.
/// Moved in x and y so that the lowest coordinates are `kMatrixCorner`; z stays. Empty if nothing is
/// deposited.
/// @param filament_diameter_mm  positive; fixes what column E counts
/// @throws InvalidInput if the diameter is not positive, or the toolpath is one of drops
std::vector<CoordinateRow> coordinateMatrix(const Toolpath& toolpath, double filament_diameter_mm);

/// As CSV: a header, then x, y and z in metres, the flag, and the filament in mm.
std::string toCsv(const std::vector<CoordinateRow>& rows);

/// How many trajectories the rows are.
std::size_t trajectoryCount(const std::vector<CoordinateRow>& rows);

/// Extrusion width [mm] of the stadium deposited when `filament_mm` is pushed forth over `length_mm` in a
/// layer of `height_mm` [Vega2023, figures 3 and 20]: h + (E pi (D/2)²/L - pi h²/4) / h, and the upright
/// stadium where that would be less than the height.
/// @throws InvalidInput if length, height or diameter is not positive, or the filament is negative
double extrusionWidth(double filament_mm, double length_mm, double height_mm, double filament_diameter_mm);

}  // namespace lamina
