// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/layer_law.hpp"

namespace lamina {

/// A correction of the amount, divided among wire feed, travel speed and power of the arc. Vectors have one
/// value per cell.
struct MetalCorrection {
  double wire = 0.0;               ///< relative change of the wire feed, one for the whole layer
  std::vector<double> speed_mm_s;  ///< travel speed
  std::vector<double> power;       ///< relative change of the source's power
  std::vector<double> amount;      ///< as it is deposited; less than asked for where the speed is limited
  double limited_share = 0.0;      ///< share of cells at which the window or the heat limited the speed
};

/// Whether the power of the source can follow the travel speed.
enum class PowerSource { Fixed, Follows };

/// Divides a correction of the amount m of a process with wire and arc, in which growth is proportional to
/// the travel speed to the power a = `loop.speed_exponent`. The mean over the layer goes to the wire feed,
/// the rest of each cell to its speed: v = v0 ((1 + m) / (1 + wire))^(1 / a), v0 being the planned speed. The
/// speed stays within least and greatest speed. If the power can follow, it changes with the speed, so that
/// the heat per length stays as planned. Otherwise the speed is limited further, so that the heat per length
/// stays within `loop.heat` of the planned one.
/// @throws InvalidConfig if the exponent is 0, or the least speed is above the greatest
/// @throws InvalidInput if at a planned speed no speed meets both limits
MetalCorrection metalSplit(const LayerCells& cells, const std::vector<double>& amount, PowerSource source,
                           const LoopSettings& settings);

}  // namespace lamina
