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
  double error_mm = 0.0;  ///< mean of planned less actual height of what is deposited; positive if too low
  double growth = 1.0;    ///< gain learnt, actual over commanded growth; positive
};

/// Layer heights and flow that are possible in a process.
struct LayerWindow {
  double least_mm = 0.0;
  double greatest_mm = 1e9;
  double greatest_flow = 2.5;  ///< greatest factor on the volume of the program; 1 over it is the least
};

/// The layers that replace those left: their heights, and a factor on the flow.
struct NewHeights {
  std::vector<double> heights_mm;
  double flow = 1.0;  ///< factor on the volume of each bead, which compensates for the gain learnt
};

/// Height error at the top of the part [mm], positive if too low, that is expected if the layers left are
/// deposited with that gain and amounts of at most the greatest one.
double expectedTopError(const PartUnderWay& part, double greatest_amount);

/// Whether corrections alone are not enough: the mean error, either way, is above the height of a layer, or
/// the top would be off by more than half of it.
bool needsReplanning(const PartUnderWay& part, double layer_mm, double greatest_amount);

/// The heights left, scaled by one factor so that the part ends at its planned top. If that factor is outside
/// 0.7 to 1.3, or a height outside the window of the process, there are more or fewer layers instead, all of
/// one height, which may differ from the planned mean by the same factors.
/// @return none if nothing is left, or no such number of layers fits the window
std::optional<NewHeights> scaledHeights(const PartUnderWay& part, const LayerWindow& window);

/// Layers of the mean planned height, in the number that ends nearest to the planned top, within half a
/// layer.
/// @return none if nothing is left, if less than half a layer is missing to the planned top, or if the mean
///   height is outside the window
std::optional<NewHeights> addedHeights(const PartUnderWay& part, const LayerWindow& window);

/// `scaledHeights` or `addedHeights`, as the setting says.
/// @return none for `Off` and `Hold`
std::optional<NewHeights> newHeights(const PartUnderWay& part, Replanning replan,
                                     const LayerWindow& window = {});

/// What is done in a region of a layer.
enum class RegionStep { None, AddLayer, SkipLayer, FillBeads };

/// The decision on a stretch: cells in a row whose error is above 0.75 layer heights, all too low or all too
/// high.
struct RegionDecision {
  RegionStep step = RegionStep::None;
  std::size_t run = 0;    ///< number in `LayerCells::runs`
  std::size_t first = 0;  ///< number of its first cell in the layer
  /// Number of cells; on a closed run they continue after its last cell with its first.
  std::size_t count = 0;
};

/// The decisions on all stretches for which something is done. On a stretch of at least three bead widths a
/// whole layer is added or left out. A shorter dip is filled by beads of its own; for a shorter bump nothing
/// is done.
std::vector<RegionDecision> regionDecisions(const LayerCells& cells, const std::vector<double>& error_mm);

}  // namespace lamina
