// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/correction_map.hpp"
#include "lamina/control/run/loop_run_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

bool isAllZero(const std::vector<double>& values);

/// What the machine is given so that a layer grows as corrected. With an exponent of the speed, amounts
/// become speeds too.
/// @param amount    relative, one per cell
/// @param shift_mm  of the nozzle, one per cell
CellCorrections cellCorrections(const LayerCells& cells, const std::vector<double>& amount,
                                const std::vector<double>& shift_mm, const LoopSettings& settings);

/// Asks once for all layers what `metalSplit` refuses of their speeds.
/// @throws InvalidInput as that
void requireSpeeds(const Toolpath& toolpath, const LoopRunSettings& settings);

}  // namespace lamina
