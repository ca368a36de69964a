// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/toolpath/timing.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// How finely motions are divided, so that joints that go steadily from waypoint to waypoint lead the nozzle
/// along the motion.
struct MotionDivision {
  double max_step_mm = 5.0;
  double max_step_deg = 5.0;             ///< that the nozzle turns by
  double tip_tolerance_mm = 0.02;        ///< of the tip from the straight line
  double tool_axis_tolerance_deg = 0.1;  ///< of the tool axis from the steady turn
};

/// Adds the keys joints.max_step_mm, joints.max_step_deg, joints.tip_tolerance_mm,
/// joints.tool_axis_tolerance_deg.
void describe(SettingsSchema& schema, MotionDivision& division);

/// A toolpath whose motions are divided into steps, and where each waypoint is from.
struct DividedToolpath {
  Toolpath toolpath;
  /// By layer, path and waypoint: the waypoint of the undivided path at which the motion that it is a step of
  /// ends. Layers and paths are the same in both.
  std::vector<std::vector<std::vector<std::uint32_t>>> original;

  /// The waypoint that reports name.
  WaypointIndex originalOf(const WaypointIndex& at) const {
    return {at.layer, at.path, original[at.layer][at.path][at.waypoint]};
  }
};

/// The toolpath, each of its waypoints its own origin.
DividedToolpath undivided(Toolpath toolpath);

/// Divides each motion into equal steps: points on the straight line, orientations by steady turns, feed,
/// bead and process values those of the motion. Drops stay where they are: waypoints in between have none.
/// What is deposited is the same.
/// @param steps  of each motion, at the place of its end among the waypoints in the order of the motion, in
///   which a closed path has its waypoint 0 twice; at least 1; what stands at the first waypoint of a path is
///   not used
DividedToolpath divided(const DividedToolpath& from, const std::vector<int>& steps);

/// Divides motions that are longer or turn the nozzle further than the greatest steps.
DividedToolpath divideMotions(Toolpath toolpath, const MotionDivision& division);

}  // namespace lamina
