// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/geometry/vector.hpp"
#include "lamina/kinematics/joint_path/motion_division.hpp"

namespace lamina {

/// How the rotation of the nozzle about its tool axis (yaw) is chosen on kinematic models that can set it.
enum class YawChoice : std::uint8_t {
  Free,  ///< by the planner, as the process is the same for every yaw
  Held,  ///< as in the toolpath
};

/// Where the joint path may change to another branch of the inverse solutions.
enum class BranchChange : std::uint8_t { OnTravel, Never };

/// How the external axes that carry the bed of an arm are positioned.
enum class ExternalChoice : std::uint8_t {
  Held,  ///< at one value
  /// Joint external_1 such that the tool axis keeps one azimuth in the robot's base frame
  /// (external_axis.hpp).
  Follow,
  Gravity,  ///< two of them such that the tool axis points down, within a cone
};

/// How the rail that carries an arm is positioned.
enum class RailChoice : std::uint8_t {
  Held,    ///< at zero
  Follow,  ///< moved steadily with the tip
  Steps,   ///< moved on travels only
};

/// How joint values are planned along a toolpath (docs/machines/joint-paths.md).
struct JointPathSettings {
  YawChoice yaw = YawChoice::Free;
  int yaw_samples = 72;  ///< number of samples of the yaw over a whole turn
  int yaw_reach = 2;     ///< greatest change of the yaw from one waypoint to the next, in samples
  /// Cost of a change of yaw [s²/rad²]; the cost of a change of a joint is (1 / its greatest speed)².
  double yaw_weight = 0.02;
  bool is_yaw_smoothed = true;  ///< whether the yaw is smoothed after the samples are chosen
  /// Number of samples of the redundancy of an arm of seven axes, over a whole turn; 1: it is held at 0.
  int redundancy_samples = 18;

  /// Rotation of a rotary joint above which a motion other than a travel is a jump.
  double max_turn_deg = 90.0;
  BranchChange branch_change = BranchChange::OnTravel;
  /// Cost of a change of branch [s]; 1 is the cost of moving one joint at its greatest speed for a second.
  double branch_change_cost = 1.0;

  double limit_margin_deg = 10.0;    ///< distance of a rotary joint from its limit below which it has a cost
  double limit_weight = 1.0;         ///< cost per second at the limit
  double singular_margin_deg = 6.0;  ///< distance from a singularity below which it has a cost
  double singular_weight = 1.0;      ///< cost per second in the singularity
  double least_margin_deg = 0.0;     ///< distance from a singularity below which the waypoint is a fault
  /// Angle by which the tool axis may deviate from the toolpath's near a singularity.
  double singular_tool_axis_tolerance_deg = 0.0;
  /// Angle by which the tool axis of a five-axis machine may deviate from the toolpath's so that a rotary
  /// joint swings less.
  double swing_tolerance_deg = 0.0;
  /// Greatest duration of a motion near a singularity, as a multiple of its duration at its feed; a slower
  /// motion counts as a standstill and is a fault.
  double max_slowdown = 100.0;

  MotionDivision division;  ///< applied by `planDividedJointPath`; `planJointPath` does not divide

  ExternalChoice external = ExternalChoice::Held;
  double external_deg = 0.0;  ///< value at which rotary external axes are held, or start value of a table
  double external_azimuth_deg = 0.0;  ///< azimuth of tool axes for `ExternalChoice::Follow`
  /// Half angle about straight down within which `ExternalChoice::Gravity` keeps tool axes.
  double external_cone_deg = 10.0;
  RailChoice rail = RailChoice::Held;

  /// Offsets of the tools' nozzles from the model's nozzle, by number of the tool [mm, bed frame]; not one of
  /// the keys joints.*. Tools beyond the list have no offset.
  std::vector<Point3> tool_offsets_mm;
};

/// Adds the keys joints.*.
void describe(SettingsSchema& schema, JointPathSettings& settings);

/// Checks the settings.
/// @throws InvalidConfig naming key, value and bound
void validate(const JointPathSettings& settings);

}  // namespace lamina
