// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/correction_map.hpp"
#include "lamina/control/run/loop_run_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

bool isAllZero(const std::vector<double>& values);

/// Corrections for the machine, and the growth of the layer with them.
struct RealisedCorrection {
  CellCorrections told;
  LayerCorrection laid;
};

/// Corrections for the machine that realise the growth decided by the loop. If a speed exponent is set, part
/// of an amount is realised by speed. Where the speed is limited, cells get less than the requested amount;
/// the share of these cells counts as limited.
/// @param asked     one amount for each cell
/// @param shift_mm  shift of the nozzle, one for each cell
RealisedCorrection realised(const LayerCells& cells, const LayerCorrection& asked,
                            const std::vector<double>& shift_mm, const LoopSettings& settings);

/// Checks for all layers at once that `metalSplit` accepts their speeds.
/// @throws InvalidInput as `metalSplit`
void requireSpeeds(const Toolpath& toolpath, const LoopRunSettings& settings);

}  // namespace lamina
