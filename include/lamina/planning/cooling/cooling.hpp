// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/base/progress.hpp"
#include "lamina/planning/cooling/cooling_settings.hpp"
#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// What was done for the cooling of layers.
struct CoolingSummary {
  std::size_t slowed_layers = 0;
  std::size_t dwells = 0;  ///< layers after which the nozzle waits; with `CoolingInterval::Place` islands
  double dwell_s = 0.0;    ///< sum
  std::size_t too_fast_layers = 0;   ///< layers that are too short even at the least feed
  std::size_t reordered_layers = 0;  ///< layers whose islands are deposited in another order than planned
};

/// Makes each layer take its least time, by the estimate with accelerations from rest to rest. Fills are
/// slowed down first, then inner walls, then outer walls and top skins, each group by one factor and only as
/// far as needed. For the time that still lacks the nozzle waits at the end of the layer, retracted and
/// lifted; not after the last one. Travels keep their feeds. A least layer time of 0 changes nothing.
/// Parallel over layers. With `CoolingInterval::Place` the time is instead that from leaving an island to
/// laying the one above it.
CoolingSummary cool(Toolpath& toolpath, const CoolingSettings& settings, const MotionLimits& limits,
                    Progress& progress);

/// Share of the fan's power for a layer that takes that time.
double fanShare(double layer_time_s, std::size_t layer, const FanSettings& settings);

/// Adds an event at each change of the fan by 1/255 or more: at the start of a layer, by its time with waits;
/// where a role has a share of its own; and before and after bridges and paths with the process value
/// `unsupported`. Raises come earlier by the fan's spin-up time, for which motions are divided. The fan is
/// switched off at the end. A fan that is not used gets no event. The process value is removed from the
/// paths, since programs have no word for it.
void addFan(Toolpath& toolpath, const FanSettings& settings, const MotionLimits& limits);

}  // namespace lamina
