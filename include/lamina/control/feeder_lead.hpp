// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/correction_map.hpp"
#include "lamina/control/layer_law.hpp"

namespace lamina {

/// How the feeder follows a command: after a dead time, then as a first-order lag.
struct FeederDelay {
  double dead_time_s = 0.0;
  double lag_s = 0.0;  ///< time constant of the first-order lag
};

/// The delay that the settings state.
FeederDelay feederOf(const LoopSettings& settings);

/// Commands to a feeder over time.
struct FeederCommands {
  std::vector<double> time_s;  ///< ascending; 0 when the nozzle starts the layer, negative before
  std::vector<double> amount;  ///< relative change commanded at that time
};

/// The commands by which the feeder deposits each correction at its place. The dead time is compensated for
/// by commanding the amount m of the place that the nozzle reaches a dead time later, at the planned speeds.
/// The lag T is compensated for by commanding m + T v dm/ds, v being the speed and s the distance along the
/// path. The commands are again limited in value and slope. Runs are taken to follow each other without a
/// pause. The first command is due a dead time before the layer starts: where the feeder cannot be commanded
/// then, the first corrections are deposited late.
/// @param amount  relative change of the volume, one value per cell
FeederCommands feederCommands(const LayerCells& cells, const std::vector<double>& amount,
                              const FeederDelay& feeder, const LoopSettings& settings);

/// The commands of `feederCommands` by place instead of time, for programs: for each cell the amount that is
/// commanded while the nozzle passes it. Commands in the last dead time of a layer act at the start of the
/// next layer: they are those of its expected beginning, or of the start of this layer if that is empty.
/// Without delay the result is `amount`.
std::vector<double> ledCorrection(const LayerCells& cells, const std::vector<double>& amount,
                                  const ExpectedBeginning& ahead, const FeederDelay& feeder,
                                  const LoopSettings& settings);

/// The amounts at the beginning of a layer, as long as a dead time lasts; none if there is no dead time. They
/// are a cell's time apart, or more where that would be more than 256 of them.
/// @param amount  relative change of the volume, one value per cell
ExpectedBeginning expectedBeginning(const LayerCells& cells, const std::vector<double>& amount,
                                    double dead_time_s);

/// The map of a layer with its amounts led as by `ledCorrection`, without what it expects of the layer above.
/// All paths get the least spacing of stations that the map has, leaving out that of paths of one station
/// which is as long as they are. Paths that `layerCells` gives no cells stay unchanged. Without delay the
/// result is `map`.
/// @throws InvalidInput as `validate`, or if the layer had more than 2 million cells so
CorrectionMap ledMap(const CorrectionMap& map, const ToolpathLayer& layer, const FeederDelay& feeder,
                     const LoopSettings& settings);

/// Times [s] at which the nozzle passes the middles of the cells, at the planned speeds and without a pause
/// between runs; 0 at the start of the layer.
std::vector<double> timesOf(const LayerCells& cells);

}  // namespace lamina
