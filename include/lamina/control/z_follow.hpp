// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/control/layer_law.hpp"

namespace lamina {

/// What limits the nozzle along the growth direction.
struct NozzleRoom {
  double layer_mm = 0.0;  ///< height of the layer
  /// Height of the highest known cell below the head, above the planned top of the layer below [mm].
  double highest_mm = 0.0;
  double clearance_mm = 0.0;  ///< height of the lowest part of the head above the nozzle tip
};

/// Shift of the nozzle along the growth direction relative to the plan [mm], one value per cell; negative if
/// lower. It depends on `loop.z`:
/// - `Plan`: zero.
/// - `Layer`, free process: minus the mean error. Pressed process: `before_mm` plus the gain of the loop
///   times the mean error, since the nozzle determines the surface.
/// - `Surface`, free process: minus the low-passed error. Pressed process: as `Layer`.
///
/// A shift of the layer as a whole changes by at most 0.2 layer heights from layer to layer. Apart from
/// `Plan`, a shift is raised as far as the head's clearance over the highest cell requires, but is never
/// greater than a layer height either way.
/// @param before_mm  mean shift of the layer below
std::vector<double> nozzleShift(const LayerCells& cells, const LayerKnowledge& known, double before_mm,
                                const NozzleRoom& room, const LoopSettings& settings);

}  // namespace lamina
