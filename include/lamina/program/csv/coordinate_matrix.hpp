// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "lamina/geometry/vector.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// How the nozzle reaches the point of a row of the coordinate matrix.
enum class CoordinateFlag : std::int8_t {
  Cut = -1,      ///< extruding; the trajectory is cut at this point, which ends one sweep and begins the next
  Start = 0,     ///< without extruding: first point of a trajectory
  Continue = 1,  ///< extruding
};

/// A row of the coordinate matrix of DECODE [Vega2023, section 3.2.3]: a point of a trajectory.
struct CoordinateRow {
  Point3 point = Point3::Zero();  ///< nozzle tip [mm]
  CoordinateFlag flag = CoordinateFlag::Start;
  double filament_mm = 0.0;  ///< length of filament fed since the trajectory began: column E
};

/// Lowest x and lowest y of the points of a coordinate matrix [mm].
inline constexpr double kMatrixCorner = 2.0;

/// The trajectories that deposit material of the part, in the order of the toolpath. A trajectory is a path
/// from its first point on; a closed path ends with its first point again. Skirts, supports and travels are
/// left out. Points are moved in x and y: their lowest coordinates become `kMatrixCorner`; z stays. Empty if
/// nothing is deposited.
/// @param filament_diameter_mm  positive; column E is the length of such filament that holds the beads'
///   volume
/// @throws InvalidInput if the diameter is not positive, or the toolpath is one of drops
std::vector<CoordinateRow> coordinateMatrix(const Toolpath& toolpath, double filament_diameter_mm);

/// The matrix as CSV: a header, then x, y and z in metres, the flag, and the filament in mm.
std::string toCsv(const std::vector<CoordinateRow>& rows);

/// Number of trajectories in the rows: the number of rows with the flag Start.
std::size_t trajectoryCount(const std::vector<CoordinateRow>& rows);

/// Width [mm] of the stadium that is deposited if the length E (`filament_mm`) of a filament of diameter D is
/// fed over the length L (`length_mm`) in a layer of height h [Vega2023, figures 3 and 20]: h + (E pi
/// (D/2)²/L - pi h²/4) / h. If that is less than the height, the width of an upright stadium of the same area
/// instead.
/// @throws InvalidInput if length, height or diameter is not positive, or the filament is negative
double extrusionWidth(double filament_mm, double length_mm, double height_mm, double filament_diameter_mm);

}  // namespace lamina
