// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "lamina/control/layer_law.hpp"

namespace lamina {

/// How a correction of the amount is shared out; one value per cell.
struct MetalCorrection {
  double wire = 0.0;               ///< relative change of the wire feed, the same for the layer
  std::vector<double> speed_mm_s;  ///< travel speed
  std::vector<double> power;       ///< relative change of the source's power
  double limited_share = 0.0;      ///< part of the cells whose speed or heat came to a limit
};

/// Whether the source's power can follow the speed.
enum class PowerSource { Fixed, Follows };

/// Splits a correction of wire and arc, where growth goes with the travel speed to the power of
/// `loop.speed_exponent`: the mean to the wire feed, what is left of each cell to the speed,
/// v = v0 ((1 + m) / (1 + wire))^(1 / a). The speed stays within its window; heat per length stays within
/// `loop.heat` of the planned: by the power where that follows, else by less speed.
/// @throws InvalidConfig if the exponent is 0, or the least speed is above the greatest
/// @throws InvalidInput if a cell's planned speed is so far outside the window that heat leaves none
MetalCorrection metalSplit(const LayerCells& cells, const std::vector<double>& amount, PowerSource source,
                           const LoopSettings& settings);

/// How a wall cools: exponentially towards what is around it.
struct CoolingWall {
  double temperature_c = 20.0;
  double ambient_c = 20.0;
  double cooling_s = 60.0;  ///< time constant
};

/// Time until a wall has come down to the loop's interpass temperature [s]; 0 if it is there already or none
/// is asked for, nothing if it never comes there.
std::optional<double> interpassDwell(const CoolingWall& wall, const LoopSettings& settings);

}  // namespace lamina
