// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/layer_law.hpp"

namespace lamina {

/// What the nozzle may do along the growth direction.
struct NozzleRoom {
  double layer_mm = 0.0;  ///< height of the layer
  /// Height of the highest believed cell under the head, above where the layer below should be [mm].
  double highest_mm = 0.0;
  double clearance_mm = 0.0;  ///< of the head above the nozzle tip
};

/// Shift of the nozzle along the growth direction against the plan, one value per cell [mm]; negative is
/// lower. By `loop.z` of a free process, whose nozzle follows the surface: none, minus the mean error of the
/// layer, or minus the low-passed error. Of a pressed one, whose nozzle makes the surface: none, or as much
/// more as the loop's gain takes of the mean error. That of the
/// layer changes by 0.2 layers at most from layer to layer, and no shift is more than a layer either way. A
/// shift down never brings the head nearer to the highest cell than its clearance.
/// @param before_mm  mean shift of the layer below
std::vector<double> nozzleShift(const LayerCells& cells, const LayerKnowledge& known, double before_mm,
                                const NozzleRoom& room, const LoopSettings& settings);

}  // namespace lamina
