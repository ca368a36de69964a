// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/base/progress.hpp"
#include "lamina/planning/flow/flow_settings.hpp"
#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Limits the flow by lower feeds. The feed of a motion that deposits a bead is at most `greatest_mm3_s`
/// divided by the bead's section. Along each run of joined paths the flow changes by at most
/// `greatest_slope_mm3_s2`: motions beside a change get waypoints, at which the feed changes in steps. Runs
/// begin and end at any flow. Beads stay as they are. Limits of 0 change nothing. Parallel over layers.
/// @param flow_factor  factor of the program on all extrusion
/// @return number of paths that are slowed down
std::size_t limitFlow(Toolpath& toolpath, const FlowSettings& settings, double flow_factor,
                      Progress& progress);

/// Result of `coast`: runs whose ends are deposited by the pressure left in the nozzle.
struct Coasting {
  std::size_t runs = 0;
  double left_mm3 = 0.0;  ///< total volume deposited by this pressure
};

/// Turns the end of each run of beads into a travel, over the length that holds `coast_mm3`, but at most
/// `coast_longest_mm` and half of the run's last path. A volume of 0 changes nothing. Parallel over layers.
Coasting coast(Toolpath& toolpath, const FlowSettings& settings, Progress& progress);

/// Result of `feedForward`: what cannot be compensated.
struct FeedForward {
  std::size_t runs = 0;  ///< all runs
  /// Volume by which beads deviate from the plan: it would have to be retracted, be pushed above the greatest
  /// flow, or leave the nozzle within the dead time.
  double unmet_mm3 = 0.0;
  double unmet_mm = 0.0;  ///< length of motions whose flow is bounded by 0 or by the greatest flow
};

/// Compensates the lag of a nozzle whose flow q follows the pushed flow u by `lag_s dq/dt + q = u(t -
/// dead_time_s)`. Each bead is replaced by the bead that must be pushed for the planned bead to leave the
/// nozzle. Times are those of the estimate from rest to rest; motions get waypoints where the flow changes.
/// The pushed flow lies between 0 and `greatest_mm3_s`. Each run starts without pressure; the pressure is
/// built up at the start of the run. Lag and dead time of 0 change nothing.
/// @param flow_factor  factor of the program on all extrusion
FeedForward feedForward(Toolpath& toolpath, const FlowSettings& settings, const MotionLimits& limits,
                        double flow_factor);

/// Adds events that set the firmware's pressure advance: at the first path that deposits, at each change of
/// the advance, and after each tool change, as firmwares keep one advance per tool. An advance of 0 for all
/// roles changes nothing.
void addAdvance(Toolpath& toolpath, const FlowSettings& settings);

}  // namespace lamina
