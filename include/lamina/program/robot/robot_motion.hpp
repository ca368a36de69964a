// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// The arm that runs a program, and its joints at the toolpath's waypoints.
struct RobotMotion {
  const KinematicModel& arm;
  const JointPath& joints;
};

}  // namespace lamina
