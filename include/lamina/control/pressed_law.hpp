// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/control/layer_law.hpp"

namespace lamina {

/// Range of the amount of a pressed process: more would become wider, then plough.
constexpr double kPressedAmount = 0.15;

/// What is known of the cross-section that a pressed layer is laid onto, one value per cell.
struct SectionKnowledge {
  std::vector<double> deficit;  ///< planned less measured over planned
  std::vector<double> gain;     ///< section over commanded section
};

/// The law of a pressed process: the nozzle sets the top, so an error of height says nothing of the amount.
/// Lack of cross-section does, measured between the valleys beside a bead: (1 + K F[deficit]) / gain - 1,
/// within 0.15 either way and the limits of the loop.
LayerCorrection pressedCorrection(const LayerCells& cells, const SectionKnowledge& known,
                                  const LoopSettings& settings);

/// What becomes of a drop.
enum class DropDecision { Lay, Leave, LayTwo };

/// Drops are corrected by their number, not by their size: where the surface is too high by half a drop, or
/// more, the drop is left out; where it is too low by as much, one more is laid.
/// @param error_mm  planned less actual height of the ground
DropDecision dropDecision(double error_mm, double drop_mm);

}  // namespace lamina
