// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/correction_map.hpp"
#include "lamina/control/run/loop_run_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

bool isAllZero(const std::vector<double>& values);

/// Corrections for the machine, and what a layer grows by with them.
struct RealisedCorrection {
  CellCorrections told;
  LayerCorrection laid;
};

/// Corrections for the machine by which a layer grows as the loop has decided. If a speed exponent is set,
/// part of an amount is realised by speed; where that is limited, the layer is laid with less than was asked
/// for, and the share of such cells is a limited share.
/// @param asked     one amount for each cell
/// @param shift_mm  shift of the nozzle, one for each cell
RealisedCorrection realised(const LayerCells& cells, const LayerCorrection& asked,
                            const std::vector<double>& shift_mm, const LoopSettings& settings);

/// Checks for all layers at once that `metalSplit` accepts their speeds.
/// @throws InvalidInput as `metalSplit`
void requireSpeeds(const Toolpath& toolpath, const LoopRunSettings& settings);

}  // namespace lamina
