// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/base/progress.hpp"
#include "lamina/planning/cooling/cooling_settings.hpp"
#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// What was done so that layers cool.
struct CoolingSummary {
  std::size_t slowed_layers = 0;
  std::size_t dwells = 0;            ///< layers that are waited for; with `CoolingInterval::Place` islands
  double dwell_s = 0.0;              ///< sum
  std::size_t too_fast_layers = 0;   ///< that even at the least feed take less than they must
  std::size_t reordered_layers = 0;  ///< whose islands are laid in another order than planned
};

/// Makes each layer take its least time, from rest to rest by the estimate with accelerations: fills, then
/// inner walls, then outer walls and top skins are slowed down, each group by one factor and only as far as
/// is needed; what still lacks is waited for at the layer's end, retracted and lifted. Travels keep their
/// feeds, and the last layer is not waited for. A least layer time of 0 changes nothing. Parallel over
/// layers. With `CoolingInterval::Place` islands are left alone for that time instead, counted from when the
/// nozzle left what lies beneath them.
CoolingSummary cool(Toolpath& toolpath, const CoolingSettings& settings, const MotionLimits& limits,
                    Progress& progress);

/// Share of the fan's power for a layer of that time.
double fanShare(double layer_time_s, std::size_t layer, const FanSettings& settings);

/// Adds an event where the fan changes by 1/255 or more, by the time that each layer takes, waiting included:
/// at the start of a layer, where a role has a share of its own, and before and after what is laid over
/// nothing, bridges and paths with the process value `unsupported`. More is told earlier by the fan's spin-up
/// time, for which motions are divided. Switches it off at the end. A fan that is not
/// used gets no event. Takes that process value from the paths, whose programs have no word for it.
void addFan(Toolpath& toolpath, const FanSettings& settings, const MotionLimits& limits);

}  // namespace lamina
