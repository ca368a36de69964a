// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/kinematics/joint_path/joint_path_settings.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Checks stated joint values, such as those of a program. Faults are values beyond their limits, rotary
/// joints that turn by more than `joints.max_turn_deg` in one motion that deposits (as on a change of
/// branch), and joints that are too slow near a singularity (`joints.max_slowdown`). A value beyond a limit
/// by no more than the rounding of a program (1e-3 mm, 1e-6 rad) is set to the limit; no other value changes.
/// Waypoints without values keep the faults they have and are not checked.
/// @param stated  joint values at the waypoints of `toolpath`
/// @param toolpath  [bed frame]
/// @return the path with all its faults, in the order of the motion
JointPath judged(JointPath stated, const Toolpath& toolpath, const KinematicModel& model,
                 const JointPathSettings& settings);

/// As `limitFault`, with a tolerance for the rounding of a program.
std::optional<std::string> statedLimitFault(JointValues values, const KinematicModel& model);

}  // namespace lamina
