// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/control/layer_law.hpp"

namespace lamina {

/// Limit of the relative amount of a pressed process, either way. More would make the bead wider, then be
/// ploughed up by the nozzle.
constexpr double kPressedAmount = 0.15;

/// What is known of the cross-section of the layer below a pressed layer, one value per cell.
struct SectionKnowledge {
  std::vector<double> deficit;  ///< planned less measured cross-section, over planned
  std::vector<double> gain;     ///< actual over commanded cross-section
};

/// The law of a pressed process. Since the nozzle sets the height, the amount follows from the lack of
/// cross-section, which is measured between the valleys beside a bead: (1 + K F[deficit]) / gain - 1, within
/// `kPressedAmount` either way and the limits of the loop. K and F are those of `freeCorrection`.
LayerCorrection pressedCorrection(const LayerCells& cells, const SectionKnowledge& known,
                                  const LoopSettings& settings);

/// What is done at the place of a drop.
enum class DropDecision { Lay, Leave, LayTwo };

/// Corrects drops by their number, not by their size: a drop is left out where the surface is too high by
/// half a drop or more, and a second one is deposited where it is too low by as much.
/// @param error_mm  planned less actual height of the surface below
/// @param drop_mm   height of a drop
DropDecision dropDecision(double error_mm, double drop_mm);

}  // namespace lamina
