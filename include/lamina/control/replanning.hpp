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
  std::vector<double> heights_left_mm;  ///< planned, of the layers not laid yet
  double error_mm = 0.0;                ///< planned less actual height of what is laid, in the mean
  double growth = 1.0;                  ///< learnt, over commanded growth
};

/// What a process lays.
struct LayerWindow {
  double least_mm = 0.0;
  double greatest_mm = 1e9;
  double greatest_flow = 2.5;  ///< over that of the program
};

/// Layers in place of those that were left, to be sliced again.
struct NewHeights {
  std::vector<double> heights_mm;
  double flow = 1.0;  ///< factor on the volume of each bead, which takes the growth learnt into the plan
};

/// Error at the top of the part if all goes on with that growth and the greatest amount [mm].
double expectedTopError(const PartUnderWay& part, double greatest_amount);

/// Whether corrections alone will not do: the mean error is above a layer, or the top would end off by more
/// than half a layer.
bool needsReplanning(const PartUnderWay& part, double layer_mm, double greatest_amount);

/// Heights so that the part ends at its planned top: those left, scaled alike. Where that leaves 0.7 to 1.3
/// of a height, or the window of the process, there are more or fewer layers.
/// @return none if nothing is left or no number of layers fits the window
std::optional<NewHeights> scaledHeights(const PartUnderWay& part, const LayerWindow& window);

/// As many layers as planned, of the planned mean height, as come nearest to the planned top: within half a
/// layer of it.
/// @return none if nothing is left, or not even half a layer is missing
std::optional<NewHeights> addedHeights(const PartUnderWay& part, const LayerWindow& window);

/// The one or the other of these, as the setting asks for.
/// @return none for `Off` and `Hold`
std::optional<NewHeights> newHeights(const PartUnderWay& part, Replanning replan,
                                     const LayerWindow& window = {});

/// What a region of a layer needs.
enum class RegionStep { None, AddLayer, SkipLayer, FillBeads };

/// For each run of cells in a row that is off by more than three quarters of a layer.
struct RegionDecision {
  RegionStep step = RegionStep::None;
  std::size_t run = 0;
  std::size_t first = 0;  ///< cell of the layer
  std::size_t count = 0;  ///< on a closed run they go on behind its last cell with its first
};

/// Whole layers are added or left out where all cells of a stretch at least three bead widths long are off by
/// more than 0.75 layers; shorter dips get beads of their own, and shorter bumps nothing.
std::vector<RegionDecision> regionDecisions(const LayerCells& cells, const std::vector<double>& error_mm);

}  // namespace lamina
