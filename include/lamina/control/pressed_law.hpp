// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/control/layer_law.hpp"

namespace lamina {

/// Greatest magnitude of the relative amount of a pressed process. Beyond it the bead would become wider and
/// be ploughed up by the nozzle.
constexpr double kPressedAmount = 0.15;

/// Known cross-section of the layer below a pressed layer, one value per cell.
struct SectionKnowledge {
  std::vector<double> deficit;  ///< planned less measured cross-section, over planned
  std::vector<double> gain;     ///< actual over commanded cross-section
};

/// The correction of a pressed process. The nozzle determines the height, so the amount follows from the
/// missing cross-section, which is measured between the valleys on both sides of a bead: (1 + K F[deficit]) /
/// gain - 1, within `kPressedAmount` either way and within the limits of the loop. K and F are the gain and
/// low-pass of the loop, as in `freeCorrection`.
LayerCorrection pressedCorrection(const LayerCells& cells, const SectionKnowledge& known,
                                  const LoopSettings& settings);

/// Number of drops where one is planned: one, none or two.
enum class DropDecision { Lay, Leave, LayTwo };

/// Corrects drops in number, not in size: a drop is left out where the surface is too high by more than half
/// a drop, and doubled where it is too low by more than half a drop.
/// @param error_mm  planned less actual height of the surface below
/// @param drop_mm   height of a drop
DropDecision dropDecision(double error_mm, double drop_mm);

}  // namespace lamina
