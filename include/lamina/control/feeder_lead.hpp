// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/correction_map.hpp"
#include "lamina/control/layer_law.hpp"

namespace lamina {

/// The delay between a command to a feeder and what it feeds.
struct FeederDelay {
  double dead_time_s = 0.0;
  double lag_s = 0.0;  ///< time constant, first order
};

/// The delay that the settings state.
FeederDelay feederOf(const LoopSettings& settings);

/// Commands to a feeder by time.
struct FeederCommands {
  std::vector<double> time_s;  ///< ascending; 0 when the nozzle starts the layer, negative before that
  std::vector<double> amount;  ///< relative change commanded at that time
};

/// Commands that make the feeder lay each correction at its place. The dead time is made up for by the amount
/// m of the place where the nozzle will be that much later at the planned speeds, the lag T by commanding m +
/// T v dm/ds. The commands are again limited in amount and slope. Runs are taken to follow each other without
/// a pause. The first command comes a dead time before the layer: a feeder that cannot be commanded then lays
/// the first corrections late.
FeederCommands feederCommands(const LayerCells& cells, const std::vector<double>& amount,
                              const FeederDelay& feeder, const LoopSettings& settings);

/// The same commands by place, for programs: for each cell the amount commanded while the nozzle passes it.
/// Commands of the last dead time of a layer belong to the start of the next layer, which is taken to have
/// the corrections of the start of this one. Without delay the result is `amount`.
std::vector<double> ledCorrection(const LayerCells& cells, const std::vector<double>& amount,
                                  const FeederDelay& feeder, const LoopSettings& settings);

/// A layer's map with its amounts led as by `ledCorrection`, at the least spacing of stations in the map.
/// Paths without cells (`layerCells`) stay unchanged. Without delay the result is `map`.
/// @throws InvalidInput as `validate`
CorrectionMap ledMap(const CorrectionMap& map, const ToolpathLayer& layer, const FeederDelay& feeder,
                     const LoopSettings& settings);

/// Times at which the nozzle passes the cells at the planned speeds [s], without a pause between runs.
std::vector<double> timesOf(const LayerCells& cells);

}  // namespace lamina
