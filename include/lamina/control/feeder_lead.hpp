// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/correction_map.hpp"
#include "lamina/control/layer_law.hpp"

namespace lamina {

/// A feeder as calibrated.
struct FeederDelay {
  double dead_time_s = 0.0;
  double lag_s = 0.0;
};

FeederDelay feederOf(const LoopSettings& settings);

/// What a feeder is told, by time.
struct FeederCommands {
  std::vector<double>
      time_s;  ///< ascending; from 0 when the nozzle sets out on the layer, before that negative
  std::vector<double> amount;
};

/// What to command so that the correction arrives at its place: m where the nozzle will be when the feeder
/// acts, by the planned speeds, and m + T v dm/ds for its lag; within the limits of amount and slope again.
/// Runs follow each other without a pause. The commands begin a dead time before the layer does: a feeder
/// that cannot be told before it starts late.
FeederCommands feederCommands(const LayerCells& cells, const std::vector<double>& amount,
                              const FeederDelay& feeder, const LoopSettings& settings);

/// The same commands at the places where the nozzle is when they are given, one value per cell, for programs
/// that command by place. The last dead time of a layer commands what the next one begins with, which is
/// taken to be what this one begins with. Without delay this is the correction itself.
std::vector<double> ledCorrection(const LayerCells& cells, const std::vector<double>& amount,
                                  const FeederDelay& feeder, const LoopSettings& settings);

/// A layer's map with its amounts led as `ledCorrection` leads them, at stations as dense as the map's
/// densest. Paths without cells (`layerCells`) stay as they are. Without delay this is the map itself.
/// @throws InvalidInput as `validate`
CorrectionMap ledMap(const CorrectionMap& map, const ToolpathLayer& layer, const FeederDelay& feeder,
                     const LoopSettings& settings);

/// When the nozzle comes by each cell at the planned speed, runs without a pause between them [s].
std::vector<double> timesOf(const LayerCells& cells);

}  // namespace lamina
