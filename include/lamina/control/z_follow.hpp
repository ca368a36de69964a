// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/layer_law.hpp"

namespace lamina {

/// Room of the nozzle along the growth direction.
struct NozzleRoom {
  double layer_mm = 0.0;  ///< height of the layer
  /// Height of the highest believed cell under the head, above where the layer below should be [mm].
  double highest_mm = 0.0;
  double clearance_mm = 0.0;  ///< of the head above the nozzle tip
};

/// Shift of the nozzle along the growth direction relative to the plan [mm], one value per cell; negative is
/// lower. `loop.z` chooses it. In a free process, whose nozzle follows the surface, it is zero, minus the
/// mean error of the layer, or minus the low-passed error. In a pressed one, whose nozzle makes the surface,
/// it is zero, or `before_mm` plus the gain of the loop times the mean error. A shift of the whole layer
/// changes by at most 0.2 layer heights from layer to layer. No shift is more than a layer height either way,
/// or brings the head nearer to the highest cell than its clearance.
/// @param before_mm  mean shift of the layer below
std::vector<double> nozzleShift(const LayerCells& cells, const LayerKnowledge& known, double before_mm,
                                const NozzleRoom& room, const LoopSettings& settings);

}  // namespace lamina
