// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Joints on the way from one waypoint to the next.
struct JointsBetween {
  double share = 0.0;  ///< of the way of the tip, in (0, 1)
  JointValues values;
};

/// Joints between two stations such that the tip, while all joints move evenly from one to the next, stays on
/// its straight line within the tolerance; the tool axis turns evenly. Pieces are halved until every one
/// keeps it, measured by forward kinematics in seven places. Empty where the two will do, or where a rotary
/// joint is wound back by more than half a turn, which leaves the line whatever stands between.
/// @param tolerance_mm  positive
/// @throws Unreachable if the machine has no joints for a pose between that follow those before steadily, or
///   the tolerance is not kept by a thousand pieces
std::vector<JointsBetween> jointsBetween(const KinematicModel& machine, const JointValues& begin,
                                         const JointValues& end, double tolerance_mm);

}  // namespace lamina
