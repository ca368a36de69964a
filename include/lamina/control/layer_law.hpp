// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/control/layer_cells.hpp"
#include "lamina/control/loop_settings.hpp"

namespace lamina {

/// What is known of the cells of a layer before it is laid, one value per cell.
struct LayerKnowledge {
  std::vector<double> error_mm;  ///< planned less actual height of what it is laid onto: positive is too low
  std::vector<double> gain;      ///< growth over commanded growth
};

/// How a layer is to be laid, one value per cell.
struct LayerCorrection {
  std::vector<double> amount;  ///< relative change of what is laid per length, within the limits of the loop
  double limited_share = 0.0;  ///< part of the length on which a limit kept the amount from what was wanted
};

/// The law of a free process, layer to layer: (1 + K F[e] / h) / gain - 1, F the low-pass along the path and
/// across beads. Limited in amount, in its slope along the path by what the feeder can follow at the planned
/// speed, and in the volume of the layer. What is learnt of the gain stands in place of an integrator, so
/// that nothing winds up at a limit.
LayerCorrection freeCorrection(const LayerCells& cells, const LayerKnowledge& known,
                               const LoopSettings& settings);

/// The same without its error term: what is learnt of the gain alone.
LayerCorrection learntCorrection(const LayerCells& cells, const std::vector<double>& gain,
                                 const LoopSettings& settings);

/// Brings what a process wants within the limits of amount, slope and volume.
LayerCorrection limitedCorrection(const LayerCells& cells, const std::vector<double>& wanted,
                                  const LoopSettings& settings);

/// Greatest change of the amount per length that the feeder follows at that speed [1/mm].
double greatestSlope(double feeder_rate_s, double speed_mm_s);

/// The amount on the way from one map to another, from a cell of a run on: it starts from the map in force,
/// and goes to the other no faster than the feeder follows. Cells before it stay.
/// @param begin  a cell; the whole run that it lies in, and those after, are changed from there
std::vector<double> fadedCorrection(const LayerCells& cells, const std::vector<double>& from,
                                    const std::vector<double>& to, std::size_t begin,
                                    const LoopSettings& settings);

}  // namespace lamina
