// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "kinematics/arm/arm_chain.hpp"
#include "kinematics/joint_path/stations.hpp"
#include "kinematics/model/joint_ranges.hpp"
#include "kinematics/model/tool_axis_turner.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// A rotary axis of a table.
struct TableAxis {
  Eigen::Index in_chain = 0;   ///< in the chain of the external axes
  std::size_t in_station = 0;  ///< among the external axes of a station
};

/// A positioner of two rotary axes under the bed of an arm, as it turns what is up over the bed.
struct GravityTable {
  std::string arm;    ///< name of the kinematic model
  ToolAxisTurner up;  ///< the axis that turns the plate first, then the one that tilts it
  TableAxis turn;
  TableAxis tilt;
  JointRange tilt_range;
  SerialChain external;  ///< the chain of the external axes
  Screw axis_1;          ///< of the arm, all external axes at zero [mm, bed frame]
};

/// Up is z of the root of the description.
/// @throws InvalidConfig if the kinematic model is no six-axis arm, has other rotary external axes than two,
///   or these are parallel, or the one that tilts turns about the vertical
GravityTable gravityTable(const KinematicModel& model);

/// How a table is led.
struct GravityRule {
  double cone = 0.0;   ///< how far a tool axis may point off straight down [rad]
  double start = 0.0;  ///< where the turn stands while tool axes leave it free at first [rad]
};

struct TableValues {
  double turn = 0.0;  ///< [rad]; goes on over whole turns
  double tilt = 0.0;  ///< [rad]
};

/// Values of a table under which all tool axes point down within the cone, for each station. Both axes go
/// like a taut string over the durations: first the tilt within half of the cone, then the turn within what
/// that leaves, anywhere where all of it is within the cone. At the first and last of what is not free the
/// tool axis points straight down. Of both ways to tilt the one that stays within the limits, then that with
/// the lesser tilt, then that which holds the tip nearer to axis 1 of the arm.
/// @throws Unreachable if the table cannot turn a tool axis down; names it
std::vector<TableValues> tableValues(const GravityTable& table, const std::vector<Station>& stations,
                                     const GravityRule& rule);

}  // namespace lamina
