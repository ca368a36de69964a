// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/layer_law.hpp"

namespace lamina {

/// A feeder as calibrated.
struct FeederDelay {
  double dead_time_s = 0.0;
  double lag_s = 0.0;
};

/// What to command at each cell so that the correction arrives at its place: m where the nozzle will be when
/// the feeder acts, by the planned speeds, and m + T v dm/ds for its lag; within the limits of amount and
/// slope again. Runs follow each other without a pause. Without delay this is the correction itself.
std::vector<double> ledCorrection(const LayerCells& cells, const std::vector<double>& amount,
                                  const FeederDelay& feeder, const LoopSettings& settings);

/// When the nozzle comes by each cell at the planned speed, runs without a pause between them [s].
std::vector<double> timesOf(const LayerCells& cells);

}  // namespace lamina
