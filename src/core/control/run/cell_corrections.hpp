// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/correction_map.hpp"
#include "lamina/control/run/loop_run_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

bool isAllZero(const std::vector<double>& values);

/// Corrections for the machine by which a layer grows as the loop has decided. If a speed exponent is set,
/// part of an amount is realised by speed.
/// @param amount    relative, one for each cell
/// @param shift_mm  shift of the nozzle, one for each cell
CellCorrections cellCorrections(const LayerCells& cells, const std::vector<double>& amount,
                                const std::vector<double>& shift_mm, const LoopSettings& settings);

/// Checks for all layers at once that `metalSplit` accepts their speeds.
/// @throws InvalidInput as `metalSplit`
void requireSpeeds(const Toolpath& toolpath, const LoopRunSettings& settings);

}  // namespace lamina
