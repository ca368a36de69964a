// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "lamina/control/layer_law.hpp"

namespace lamina {

/// A correction of the amount, divided among wire feed, travel speed and power. Vectors have one value per
/// cell.
struct MetalCorrection {
  double wire = 0.0;               ///< relative change of the wire feed, the same for the layer
  std::vector<double> speed_mm_s;  ///< travel speed
  std::vector<double> power;       ///< relative change of the source's power
  double limited_share = 0.0;      ///< share of cells whose speed or heat was limited
};

/// Whether the source's power can follow the speed.
enum class PowerSource { Fixed, Follows };

/// Divides a correction of the amount m of wire and arc, where growth goes with the travel speed to the power
/// a = `loop.speed_exponent`. The mean goes to the wire feed, the rest of each cell to its speed: v = v0 ((1
/// + m) / (1 + wire))^(1 / a). The speed stays within its window. Heat per length stays within `loop.heat` of
/// the planned: by the power if it can follow, else by a smaller change of speed.
/// @throws InvalidConfig if the exponent is 0, or the least speed is above the greatest
/// @throws InvalidInput if a cell's planned speed is so far outside the window that heat leaves none
MetalCorrection metalSplit(const LayerCells& cells, const std::vector<double>& amount, PowerSource source,
                           const LoopSettings& settings);

/// A wall that cools exponentially towards the ambient temperature.
struct CoolingWall {
  double temperature_c = 20.0;
  double ambient_c = 20.0;
  double cooling_s = 60.0;  ///< time constant
};

/// Time until a wall has cooled to the interpass temperature of the settings [s]; 0 if it has already or none
/// is set, nothing if it never will.
std::optional<double> interpassDwell(const CoolingWall& wall, const LoopSettings& settings);

}  // namespace lamina
