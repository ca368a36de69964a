// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/toolpath/timing.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// How finely motions are divided. Joints that move at constant speed between waypoints then keep the nozzle
/// on the motion.
struct MotionDivision {
  double max_step_mm = 5.0;              ///< greatest length of a step
  double max_step_deg = 5.0;             ///< greatest rotation of the nozzle in a step
  double tip_tolerance_mm = 0.02;        ///< greatest deviation of the tip from the straight line
  double tool_axis_tolerance_deg = 0.1;  ///< greatest deviation of the tool axis from its interpolation
};

/// Adds the keys joints.max_step_mm, joints.max_step_deg, joints.tip_tolerance_mm,
/// joints.tool_axis_tolerance_deg.
void describe(SettingsSchema& schema, MotionDivision& division);

/// A toolpath whose motions are divided into steps, with the original waypoint of each waypoint.
struct DividedToolpath {
  Toolpath toolpath;
  /// Index of the original waypoint, by layer, path and waypoint: the end of the undivided motion that
  /// contains the step. Layers and paths are the same in both toolpaths.
  std::vector<std::vector<std::vector<std::uint32_t>>> original;

  /// The original waypoint, for reports.
  WaypointIndex originalOf(const WaypointIndex& at) const {
    return {at.layer, at.path, original[at.layer][at.path][at.waypoint]};
  }
};

/// The toolpath as it is, each waypoint being its own original.
DividedToolpath undivided(Toolpath toolpath);

/// Divides each motion into equal steps: points on the straight line, orientations at constant angular speed,
/// and feed, bead and process values of the motion. Drops are kept where they are; the new waypoints have
/// none. What is deposited does not change.
/// @param steps  number of steps of each motion, at least 1, indexed by the waypoint at the end of the
///   motion; waypoints count in the order of the motion, in which a closed path has its waypoint 0 twice. The
///   entry of the first waypoint of a path is not used
DividedToolpath divided(const DividedToolpath& from, const std::vector<int>& steps);

/// Number of steps of each motion, for `divided`, with which no step exceeds the greatest steps.
std::vector<int> stepsWithin(const Toolpath& toolpath, const MotionDivision& division);

/// Divides the motions that are longer, or rotate the nozzle further, than the greatest steps.
DividedToolpath divideMotions(Toolpath toolpath, const MotionDivision& division);

}  // namespace lamina
