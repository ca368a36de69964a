// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// What a program has a machine or robot do: its joints as they stand in the file, not as they might be led.
struct StatedMotion {
  Toolpath toolpath;               ///< in coordinates of the bed; each line that moves is a waypoint
  JointPath joints;                ///< of it; faults are those of waypoints that have no joints
  std::vector<std::size_t> lines;  ///< that state them, 1 based; as many as `joints.at`
};

}  // namespace lamina
