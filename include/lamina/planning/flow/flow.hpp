// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/base/progress.hpp"
#include "lamina/planning/flow/flow_settings.hpp"
#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Lowers the feed of every motion that deposits a bead to `greatest_mm3_s` over the bead's section, and then
/// along each run of joined paths so that the flow changes by `greatest_slope_mm3_s2` at most: motions beside
/// a change get waypoints, between which it is followed in steps. Runs begin and end at any flow. Beads stay
/// as they are. Limits of 0 change nothing. Parallel over layers.
/// @param flow_factor  of the program on all that is deposited
/// @return number of paths that are slowed down
std::size_t limitFlow(Toolpath& toolpath, const FlowSettings& settings, double flow_factor,
                      Progress& progress);

/// Runs whose end is left to the pressure in the nozzle.
struct Coasting {
  std::size_t runs = 0;
  double left_mm3 = 0.0;  ///< not pushed, in all
};

/// Makes a travel of the end of each run of beads, as long as it takes `coast_mm3`, at most
/// `coast_longest_mm` and half of the run's last path. A volume of 0 changes nothing. Parallel over layers.
Coasting coast(Toolpath& toolpath, const FlowSettings& settings, Progress& progress);

/// What a program that makes up for a lag could not.
struct FeedForward {
  std::size_t runs = 0;
  /// That was to be pulled back, pushed faster than the flow may be, or to arrive within the dead time.
  double unmet_mm3 = 0.0;
  double unmet_mm = 0.0;  ///< length of the runs where that is so
};

/// Makes up for a nozzle whose flow q follows what is pushed, u, by `lag_s dq/dt + q = u(t - dead_time_s)`:
/// beads become what is to be pushed where, so that planned ones leave the nozzle. Times are those of the
/// estimate from rest to rest; motions get waypoints where the flow changes. What is to be pushed lies
/// between 0 and `greatest_mm3_s`; each run starts with nothing in store, and what it needs there is pushed
/// as it starts. Lag and dead time of 0 change nothing.
/// @param flow_factor  of the program on all that is deposited
FeedForward feedForward(Toolpath& toolpath, const FlowSettings& settings, const MotionLimits& limits,
                        double flow_factor);

/// Tells the firmware the advance of the first path that deposits, and others where they change. An advance
/// of 0 for all roles changes nothing.
void addAdvance(Toolpath& toolpath, const FlowSettings& settings);

}  // namespace lamina
