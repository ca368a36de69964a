// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/toolpath/motion_limits.hpp"
#include "planning/cooling/fan_schedule.hpp"

namespace lamina {

/// Adds the changes as events, those to a greater share earlier by the time that the fan takes to spin up, by
/// the estimate with accelerations: motions are divided where that is. A lull shorter than the spin-up is
/// none. What begins earlier than the toolpath begins with it.
/// @param changes  in the order of the motion
void addSentEarlier(Toolpath& toolpath, const std::vector<FanChange>& changes, double spin_up_s,
                    const MotionLimits& limits);

}  // namespace lamina
