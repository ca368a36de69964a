// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/control/layer_cells.hpp"
#include "lamina/control/loop_settings.hpp"

namespace lamina {

/// The known state of a layer's cells before the layer is deposited, one value per cell.
struct LayerKnowledge {
  std::vector<double> error_mm;  ///< planned minus actual height of the surface below; positive if too low
  std::vector<double> gain;      ///< ratio of actual to commanded growth
};

/// The correction of a layer, one value per cell.
struct LayerCorrection {
  std::vector<double> amount;  ///< relative change of the volume per length, within the limits of the loop
  /// Share of the length on which the limit on value or on volume changed the amount; the limit on slope does
  /// not count.
  double limited_share = 0.0;
};

/// The layer-to-layer law of a free process. The amount is (1 + K F[e] / h) / g - 1. K is the gain of the
/// loop, F the low-pass along the path and across beads, e the height error, h the planned height of the
/// layer, and g the learnt gain of the process. Limits apply to the amount, to the change of the layer's
/// volume, and to the slope along the path, which is at most what the feeder follows at the planned speed.
/// The law has no integrator, since g is learnt; so nothing winds up at a limit.
LayerCorrection freeCorrection(const LayerCells& cells, const LayerKnowledge& known,
                               const LoopSettings& settings);

/// The correction from the learnt gain alone, without the error term: 1 / g - 1, within the same limits.
LayerCorrection learntCorrection(const LayerCells& cells, const std::vector<double>& gain,
                                 const LoopSettings& settings);

/// The wanted amounts, limited in value, then in volume of the layer, then in slope, which leaves each run
/// its volume. Amounts that are not finite become 0.
LayerCorrection limitedCorrection(const LayerCells& cells, const std::vector<double>& wanted,
                                  const LoopSettings& settings);

/// Commands that a feeder can follow: the wanted ones, limited in value and in slope. An edge is cut equally
/// on both sides and keeps its place; the volume of a run may change. Values that are not finite become 0.
std::vector<double> followedCommands(const LayerCells& cells, const std::vector<double>& wanted,
                                     const LoopSettings& settings);

/// The greatest slope of the amount along a path that the feeder can follow at a speed [1/mm]; infinite at
/// speed 0.
double greatestSlope(double feeder_rate_s, double speed_mm_s);

/// The amounts of a layer whose map is replaced while the layer is deposited, one per cell. Cells before
/// `begin` keep the amounts `from`. From `begin` on, the amount goes from that of the cell before to those of
/// `to`, no faster than the feeder follows; this may last over several runs. Once an amount of `to` is
/// reached, or a path without cells was deposited as planned, all further amounts are those of `to`. They may
/// step from path to path, as the feeder rests in between.
/// @param from   amounts of the map that is in force
/// @param to     amounts of the map that replaces it
/// @param begin  first cell that the new map may change
std::vector<double> fadedCorrection(const LayerCells& cells, const std::vector<double>& from,
                                    const std::vector<double>& to, std::size_t begin,
                                    const LoopSettings& settings);

}  // namespace lamina
