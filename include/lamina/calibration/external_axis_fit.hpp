// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A mark that a robot's tip touched while an external axis stood at a value.
struct AxisTouch {
  double value = 0.0;            ///< of the axis, as its controller shows it [deg or mm]
  Point3 base = Point3::Zero();  ///< the mark in the robot's base [mm]
  std::size_t line = 0;          ///< of the table that states it, from 1; 0 if none does
};

/// How touches of one mark agree with the axis that was found by them.
struct AxisAgreement {
  double rms_mm = 0.0;                ///< of the distances between the mark as touched and as the axis has it
  std::vector<double> distances_mm;   ///< of each touch
  std::vector<std::size_t> outlying;  ///< touches that contradict the others, by index; all are fitted
};

/// The axis about which a positioner turns.
struct TurningAxisFit : AxisAgreement {
  Point3 direction = Point3::UnitZ();  ///< in the base: greater values turn it to the right about this
  Point3 centre = Point3::Zero();      ///< of the circle of the mark, a point of the axis, in the base [mm]
  double radius_mm = 0.0;              ///< of that circle
  double direction_spread_deg = 0.0;   ///< standard deviation of the angle by which the direction is off
  double centre_spread_mm = 0.0;       ///< standard deviation of the distance by which the axis is off
};

/// The axis of a positioner by one mark on its plate, touched at several angles: the circle, passed at these
/// angles, that is nearest in the least squares [Kabsch1976].
/// @throws InvalidInput if there are fewer than three touches, or if they lie within 1 mm of one line
TurningAxisFit fitTurningAxis(const std::vector<AxisTouch>& touches);

/// The axis along which a rail carries a robot.
struct RailFit : AxisAgreement {
  Point3 direction = Point3::UnitX();  ///< in which greater values carry the robot, in its base
  double way_per_value = 1.0;          ///< way of the robot for each millimetre that its controller shows
  double direction_spread_deg = 0.0;   ///< standard deviation of the angle by which the direction is off
};

/// The axis of a rail by one mark in the room, touched at several values. The base goes with the robot, so
/// that the mark moves against the rail.
/// @throws InvalidInput if there are fewer than three touches, if their values span less than 1 mm, or if the
///   mark moves by less than half the values: then its coordinates are not over the base that the rail
///   carries
RailFit fitRail(const std::vector<AxisTouch>& touches);

/// Reads touches from CSV, one a row, with the columns x_mm, y_mm, z_mm and the value of the axis.
/// @param value   name of that column: angle_deg, rail_mm
/// @param source  names the table in errors
/// @throws InvalidInput naming the line if a cell is not a number below 1e12; also if a column is missing
std::vector<AxisTouch> axisTouchesFromCsv(std::string_view text, const std::string& value,
                                          const std::string& source);

}  // namespace lamina
