// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/kinematics/joint_path/joint_path_settings.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Judges joints that are stated, as by a program, and leaves them as they are: joints beyond their limits,
/// rotary joints that turn by more than `joints.max_turn_deg` in one motion that deposits (as where a branch
/// is left for another), and joints that are too slow beside a singularity (`joints.max_slowdown`). Values
/// that are beyond a limit by no more than the decimals of a program (1e-3 mm, 1e-6 rad) are put to it.
/// Waypoints without values keep the faults that they came with, and are not judged.
/// @param stated  of the toolpath, which lies in coordinates of the bed
/// @return the path with all its faults, in the order of the motion
JointPath judged(JointPath stated, const Toolpath& toolpath, const KinematicModel& model,
                 const JointPathSettings& settings);

}  // namespace lamina
