// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Joint values between two waypoints.
struct JointsBetween {
  double share = 0.0;  ///< position between the waypoints, as a share of the tip's path, in (0, 1)
  JointValues values;
};

/// Joint values to be inserted between two stations so that the tip stays on its straight line within the
/// tolerance while all joints move evenly from one set of values to the next. The tool axis turns evenly
/// along the line. Pieces are halved until forward kinematics at seven places of each shows the tolerance
/// kept. Empty if nothing needs to be inserted, or if a rotary joint is turned back by more than half a turn,
/// as then the tip leaves the line whatever is inserted.
/// @param tolerance_mm  positive
/// @throws Unreachable if the machine has no joint values for a pose on the line that continue the ones
///   before steadily, or the tolerance is not kept with a thousand pieces
std::vector<JointsBetween> jointsBetween(const KinematicModel& machine, const JointValues& begin,
                                         const JointValues& end, double tolerance_mm);

}  // namespace lamina
