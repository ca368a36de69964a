// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The motion that a program commands of a machine or robot, with joint values as the program states them
/// instead of planned ones.
struct StatedMotion {
  Toolpath toolpath;  ///< in coordinates of the bed; each line that moves is a waypoint
  JointPath joints;   ///< at the waypoints; faults are those of waypoints without joints
  /// Numbers of the lines that state the waypoints, 1 based; as many as `joints.at`.
  std::vector<std::size_t> lines;
};

}  // namespace lamina
