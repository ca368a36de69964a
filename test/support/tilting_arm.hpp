// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <string>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"
#include "support/arms.hpp"

namespace lamina::test {

/// Limits of the table of `tiltingArm`, as its URDF has them.
struct TableLimits {
  std::string low = "-2.3";  ///< of the tilt
  std::string high = "2.3";
  std::string turn = "";  ///< of the plate to either side; without it the plate turns on and on
};

/// An arm over a bed that a cradle tilts about y (external_1) and a plate in it turns about z (external_2).
/// @param turn_axis  of the plate
inline std::string tiltingArm(const TableLimits& limits = {}, const std::string& turn_axis = "0 0 1") {
  std::string text = exactParallelAxesArm().urdf();
  const std::string parent = "<parent link=\"base_link\"/><child link=\"bed\"/>";
  text.replace(text.find(parent), parent.size(), "<parent link=\"plate\"/><child link=\"bed\"/>");
  const std::string table =
      "<link name=\"cradle\"/><link name=\"plate\"/>"
      "<joint name=\"external_1\" type=\"revolute\"><parent link=\"base_link\"/><child link=\"cradle\"/>"
      "<origin xyz=\"0.7 0.1 0.1\"/><axis xyz=\"0 1 0\"/><limit lower=\"" +
      limits.low + "\" upper=\"" + limits.high +
      "\" velocity=\"1\" effort=\"1\"/></joint>"
      "<joint name=\"external_2\" type=\"" +
      (limits.turn.empty() ? "continuous" : "revolute") +
      "\"><parent link=\"cradle\"/><child link=\"plate\"/><axis xyz=\"" + turn_axis + "\"/><limit " +
      (limits.turn.empty() ? "" : "lower=\"-" + limits.turn + "\" upper=\"" + limits.turn + "\" ") +
      "velocity=\"2\" effort=\"1\"/></joint>";
  const std::string end = "</robot>";
  return text.replace(text.find(end), end.size(), table + end);
}

/// A nozzle that lays a wall leaning outwards, seen from the axis at an azimuth [rad].
inline Eigen::Quaterniond nozzleOnWall(double azimuth, double lean) {
  const Eigen::AngleAxisd turn(lean, Point3(-std::sin(azimuth), std::cos(azimuth), 0.0));
  return turn * Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0);
}

}  // namespace lamina::test
