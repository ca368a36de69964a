// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lamina/control/layer_cells.hpp"
#include "lamina/control/loop_settings.hpp"

namespace lamina {

/// A part that is under way, as heights along its growth direction.
struct PartUnderWay {
  std::vector<double> heights_left_mm;  ///< planned heights of the layers not deposited yet
  double error_mm = 0.0;                ///< mean of planned less actual height of what is deposited
  double growth = 1.0;                  ///< gain learnt, actual over commanded growth
};

/// Heights of layers and flow that a process can lay.
struct LayerWindow {
  double least_mm = 0.0;
  double greatest_mm = 1e9;
  double greatest_flow = 2.5;  ///< factor on the volume of the program
};

/// The layers that replace those left.
struct NewHeights {
  std::vector<double> heights_mm;
  double flow = 1.0;  ///< factor on the volume of each bead, which makes up for the gain learnt
};

/// Height error at the top of the part [mm], if the layers left are deposited with that growth and the
/// greatest amount.
double expectedTopError(const PartUnderWay& part, double greatest_amount);

/// Whether corrections alone are not enough: the mean error is above the height of a layer, or the top would
/// be off by more than half of it.
bool needsReplanning(const PartUnderWay& part, double layer_mm, double greatest_amount);

/// The heights left, scaled by one factor so that the part ends at its planned top. If that factor is outside
/// 0.7 to 1.3, or a height outside the window of the process, there are more or fewer layers.
/// @return none if nothing is left or no number of layers fits the window
std::optional<NewHeights> scaledHeights(const PartUnderWay& part, const LayerWindow& window);

/// Layers of the mean planned height, in the number that ends nearest to the planned top, within half a
/// layer.
/// @return none if nothing is left, or not even half a layer is missing
std::optional<NewHeights> addedHeights(const PartUnderWay& part, const LayerWindow& window);

/// `scaledHeights` or `addedHeights`, as the setting asks for.
/// @return none for `Off` and `Hold`
std::optional<NewHeights> newHeights(const PartUnderWay& part, Replanning replan,
                                     const LayerWindow& window = {});

/// What is done in a region of a layer.
enum class RegionStep { None, AddLayer, SkipLayer, FillBeads };

/// The decision for a stretch of cells in a row that are off by more than 0.75 layers.
struct RegionDecision {
  RegionStep step = RegionStep::None;
  std::size_t run = 0;
  std::size_t first = 0;  ///< number of its first cell in the layer
  std::size_t count = 0;  ///< of cells; on a closed run they continue after its last cell with its first
};

/// Decides on all such stretches. A whole layer is added or left out on a stretch of at least three bead
/// widths; a shorter dip gets beads of its own, a shorter bump nothing.
std::vector<RegionDecision> regionDecisions(const LayerCells& cells, const std::vector<double>& error_mm);

}  // namespace lamina
