// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A touch of a mark by a robot's tip, at one position of an external axis.
struct AxisTouch {
  double value = 0.0;            ///< position of the axis, as its controller shows it [deg or mm]
  Point3 base = Point3::Zero();  ///< position of the mark [mm, frame of the robot's base]
  std::size_t line = 0;          ///< line of the table that states the touch, from 1; 0 if none does
};

/// Agreement of the touches of one mark with the axis fitted to them.
struct AxisAgreement {
  double rms_mm = 0.0;                ///< root mean square of the distances
  std::vector<double> distances_mm;   ///< of each touch from the place that the fitted axis gives the mark
  std::vector<std::size_t> outlying;  ///< indices of touches that contradict the others; all are fitted
};

/// The axis about which a positioner turns.
struct TurningAxisFit : AxisAgreement {
  Point3 direction = Point3::UnitZ();  ///< greater values turn right-handed about this [frame of the base]
  Point3 centre = Point3::Zero();     ///< of the circle of the mark; lies on the axis [mm, frame of the base]
  double radius_mm = 0.0;             ///< of that circle
  double direction_spread_deg = 0.0;  ///< standard deviation of the error of the direction
  double centre_spread_mm = 0.0;      ///< standard deviation of the error of the centre [mm]
};

/// Fits the axis of a positioner to touches of one mark on its plate at several angles: the circle whose
/// points at these angles are nearest to the touches by least squares [Kabsch1976].
/// @throws InvalidInput if there are fewer than three touches, or if they lie within 1 mm of one line
TurningAxisFit fitTurningAxis(const std::vector<AxisTouch>& touches);

/// The axis along which a rail carries a robot.
struct RailFit : AxisAgreement {
  Point3 direction = Point3::UnitX();  ///< in which greater values carry the robot [frame of its base]
  double way_per_value = 1.0;          ///< distance the robot moves per millimetre that its controller shows
  double direction_spread_deg = 0.0;   ///< standard deviation of the error of the direction
};

/// Fits the axis of a rail to touches of one mark fixed in the room, at several values. The base moves with
/// the robot, so that in its frame the mark moves in the opposite direction.
/// @throws InvalidInput if there are fewer than three touches, if their values span less than 1 mm, or if the
///   mark moves by less than half the change of the values: its coordinates then do not refer to the base
///   that the rail carries
RailFit fitRail(const std::vector<AxisTouch>& touches);

/// Reads touches from CSV, one per row, with the columns x_mm, y_mm, z_mm and the value of the axis.
/// @param value   name of that column: angle_deg, rail_mm
/// @param source  names the table in errors
/// @throws InvalidInput naming the line if a cell is not a number below 1e12; also if a column is missing
std::vector<AxisTouch> axisTouchesFromCsv(std::string_view text, const std::string& value,
                                          const std::string& source);

}  // namespace lamina
