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
  Eigen::Index in_chain = 0;   ///< index in the chain of the external axes
  std::size_t in_station = 0;  ///< index among the external axes of a station
};

/// A positioner with two rotary axes under the bed of an arm, described by how it turns the direction that is
/// up over the bed.
struct GravityTable {
  std::string arm;    ///< name of the kinematic model
  ToolAxisTurner up;  ///< first the axis that turns the plate, then the axis that tilts it
  TableAxis turn;
  TableAxis tilt;
  JointRange turn_range;
  JointRange tilt_range;
  SerialChain external;  ///< chain of the external axes
  Screw axis_1;          ///< axis 1 of the arm, with all external axes at zero [mm, bed frame]
};

/// The positioner of a kinematic model. Up is z of the description's root.
/// @throws InvalidConfig if the kinematic model is no arm or does not have exactly two rotary
///   external axes, or if these are parallel or the tilting one is vertical
GravityTable gravityTable(const KinematicModel& model);

/// Settings by which a table is moved with gravity.
struct GravityRule {
  double cone = 0.0;  ///< greatest angle of a tool axis from straight down [rad]
  /// Value of the turning axis until a tool axis first determines it [rad].
  double start = 0.0;
};

struct TableValues {
  double turn = 0.0;  ///< [rad]; continues beyond whole turns
  double tilt = 0.0;  ///< [rad]
};

/// Values of a table, for each station, with which all tool axes point down within the cone. Both axes move
/// like a taut string over the durations: first the tilt, within half of the cone, then the turn, within what
/// the tilt leaves of the cone. Where every value of the turn keeps the tool axis within the cone, the turn
/// is free. At the first and the last station at which it is not free the tool axis points straight down.
/// Where such turns do not fit into the limits of the turning axis between two clear travels, the turn has a
/// string of its own between each two, within its limits, and changes from one to the next on the clear
/// travel; at both ends of each string the tool axis points straight down, or as nearly as the limits allow.
/// If limits and cone leave no way between two travels, the turns there exceed the limits. Of the two
/// possible tilts, the one within the limits is chosen, then the lesser one, then the one that brings the tip
/// nearer to axis 1 of the arm.
/// @throws Unreachable naming the table if it cannot turn a tool axis down
std::vector<TableValues> tableValues(const GravityTable& table, const std::vector<Station>& stations,
                                     const GravityRule& rule);

}  // namespace lamina
