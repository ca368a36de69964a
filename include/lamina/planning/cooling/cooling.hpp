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
  /// Number of waits: after layers, or with `CoolingInterval::Place` before islands.
  std::size_t dwells = 0;
  double dwell_s = 0.0;              ///< total duration of these waits
  std::size_t too_fast_layers = 0;   ///< layers that are too short even at the least feed
  std::size_t reordered_layers = 0;  ///< layers whose islands are deposited in another order than planned
};

/// Makes each layer last at least `least_layer_time_s`, by the time estimate with accelerations, from rest to
/// rest. Fills are slowed down first, then inner walls, then outer walls and top skins, each group by one
/// factor and only as far as needed. If that is not enough, the nozzle waits for the remaining time at the
/// end of the layer, retracted and lifted; not after the last layer. Travels keep their feeds. A least layer
/// time of 0 changes nothing. Parallel over layers. With `CoolingInterval::Place` the least time applies
/// instead from the end of an island to the start of the island above it.
CoolingSummary cool(Toolpath& toolpath, const CoolingSettings& settings, const MotionLimits& limits,
                    Progress& progress);

/// Share of the fan's power for a layer.
/// @param layer_time_s  duration of the layer
/// @param layer  number, from 0
double fanShare(double layer_time_s, std::size_t layer, const FanSettings& settings);

/// Adds an event at each change of the fan by 1/255 or more: at the start of a layer, by the layer's time
/// with waits; where a role has a share of its own; and before and after bridges and paths with the process
/// value `unsupported`. Events that raise the power come earlier by the fan's spin-up time; motions are
/// divided there. The fan is switched off at the end. A fan that is not used gets no event. In all cases the
/// process value is removed from the paths, since no command of a program states it.
void addFan(Toolpath& toolpath, const FanSettings& settings, const MotionLimits& limits);

}  // namespace lamina
