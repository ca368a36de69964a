// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/trajectory/joint_trajectory.hpp"
#include "trajectory/timeline.hpp"

namespace lamina {

/// Joints at a time, averaged over the `averaging_s` before it (not averaged if 0), and the flow; all process
/// signals are off. Averages keep every limit on speed and acceleration, and bound the jerk of a joint by
/// twice its acceleration over `averaging_s`.
JointState motionSample(const Timeline& timeline, double averaging_s, double time_s);

}  // namespace lamina
