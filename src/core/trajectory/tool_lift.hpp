// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "lamina/trajectory/trajectory_feeder.hpp"
#include "trajectory/timed_motion.hpp"

namespace lamina {

/// The motion from rest to rest that takes the tip straight against its tool axis, the tool axis held.
/// Nothing is deposited.
/// @throws InvalidInput if height or speed is not positive
/// @throws Unreachable if a joint would leave its limits, or the way cannot be followed
std::shared_ptr<const TimedMotion> toolLift(const JointValues& from, const ToolLift& lift,
                                            const KinematicModel& model, const TimingSettings& settings);

}  // namespace lamina
