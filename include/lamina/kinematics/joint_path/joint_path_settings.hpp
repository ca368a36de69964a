// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "lamina/base/settings_schema.hpp"
#include "lamina/kinematics/joint_path/motion_division.hpp"

namespace lamina {

/// Where the turn of the nozzle about its tool axis comes from, on kinematic models that bring it about.
enum class YawChoice : std::uint8_t {
  Free,  ///< the planner chooses it: a tool axis is the same all around
  Held,  ///< it is that of the toolpath
};

/// Where a kinematic model may go over to another of its branches.
enum class BranchChange : std::uint8_t { OnTravel, Never };

/// Where the external axes of an arm that turn its bed stand.
enum class ExternalChoice : std::uint8_t {
  Held,    ///< at one value
  Follow,  ///< external_1 so that the tool axis goes at one azimuth over the robot's base (external_axis.hpp)
  Gravity,  ///< two of them so that the tool axis points down, within a cone
};

/// How the joints are led along a toolpath (docs/machines/joint-paths.md).
struct JointPathSettings {
  YawChoice yaw = YawChoice::Free;
  int yaw_samples = 72;         ///< of the whole turn about the tool axis
  int yaw_reach = 2;            ///< samples that the yaw may change by from a waypoint to the next, at most
  double yaw_weight = 0.02;     ///< [s²/rad²]; a joint counts by 1 / its greatest speed, squared
  bool is_yaw_smoothed = true;  ///< between the samples, after they are chosen

  double max_turn_deg = 90.0;  ///< of a rotary joint in one motion other than a travel; more is a jump
  BranchChange branch_change = BranchChange::OnTravel;
  double branch_change_cost = 1.0;  ///< [s], as much as one second at the greatest speed of a joint

  double limit_margin_deg = 10.0;    ///< a rotary joint nearer to its limit costs
  double limit_weight = 1.0;         ///< cost per second at the limit
  double singular_margin_deg = 6.0;  ///< a singularity that is nearer costs
  double singular_weight = 1.0;      ///< cost per second in the singularity
  double least_margin_deg = 0.0;     ///< a singularity that is nearer is a fault
  double singular_tool_axis_tolerance_deg =
      0.0;  ///< by which the tool axis may leave what is asked in a singularity
  /// By which the tool axis of a machine of five axes may leave what is asked so that a joint swings less.
  double swing_tolerance_deg = 0.0;
  /// Near a singularity: duration of a motion over that at its feed, at most; as much is standing still.
  double max_slowdown = 100.0;

  MotionDivision division;  ///< before joints are found; `planJointPath` does not divide

  ExternalChoice external = ExternalChoice::Held;
  double external_deg = 0.0;          ///< where rotary external axes are held, or where a table starts
  double external_azimuth_deg = 0.0;  ///< at which tool axes go if it follows them
  double external_cone_deg = 10.0;    ///< about straight down, in which gravity keeps tool axes
};

/// Adds the keys joints.*.
void describe(SettingsSchema& schema, JointPathSettings& settings);

/// @throws InvalidConfig naming key, value and bound
void validate(const JointPathSettings& settings);

}  // namespace lamina
