// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// What moves steadily from one stated waypoint to the next.
enum class StatedMove : std::uint8_t {
  Joints,  ///< the joints
  Nozzle,  ///< the nozzle: its tip on a straight line, its orientation at constant angular speed
};

/// The motion that a program commands of a machine or robot, with joint values as the program states them
/// instead of planned ones.
struct StatedMotion {
  Toolpath toolpath;  ///< in coordinates of the bed; each line that moves is a waypoint
  JointPath joints;   ///< at the waypoints; faults are those of waypoints without joints
  /// Numbers of the lines that state the waypoints, 1 based; as many as `joints.at`.
  std::vector<std::size_t> lines;
  StatedMove between = StatedMove::Joints;
};

}  // namespace lamina
