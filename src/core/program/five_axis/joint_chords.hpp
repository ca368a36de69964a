// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/vector.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Joints between two stations such that the tip, while all joints move evenly from one to the next, stays on
/// its straight line within the tolerance; the tool axis turns evenly. Empty where the two will do, or where
/// a rotary joint is wound back by more than half a turn, which leaves the line whatever stands between.
/// @param tolerance_mm  positive
/// @throws Unreachable if the machine has no joints for a pose between that follow those before steadily
std::vector<JointValues> jointsBetween(const KinematicModel& machine, const JointValues& begin,
                                       const JointValues& end, double tolerance_mm);

}  // namespace lamina
