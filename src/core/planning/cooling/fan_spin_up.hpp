// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/toolpath/motion_limits.hpp"
#include "planning/cooling/fan_schedule.hpp"

namespace lamina {

/// Adds the changes as events. A change to a greater share comes earlier by the fan's spin-up time, by the
/// estimate with accelerations; motions are divided there. A lower share for less than that time is left out.
/// No event comes before the start of the toolpath.
/// @param changes  in the order of motion
void addSentEarlier(Toolpath& toolpath, const std::vector<FanChange>& changes, double spin_up_s,
                    const MotionLimits& limits);

}  // namespace lamina
