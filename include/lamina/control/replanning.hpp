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
  /// Greatest factor on the volume of the program; the least factor is 1 over it.
  double greatest_flow = 2.5;
};

/// The layers that replace the layers left: their heights, and a factor on the flow.
struct NewHeights {
  std::vector<double> heights_mm;
  double flow = 1.0;  ///< factor on the volume of each bead, which compensates for the gain learnt
};

/// Limits of the relative amount of a whole layer.
struct LayerAuthority {
  double least = 0.0;     ///< above -1, at most 0
  double greatest = 0.0;  ///< at least 0
};

/// Height error at the top of the part [mm], positive if too low, that is expected if the layers left are
/// deposited with that gain and amounts within the limits. It is 0 if amounts within the limits make up for
/// the present error.
double expectedTopError(const PartUnderWay& part, const LayerAuthority& authority);

/// Whether corrections alone are not enough: the mean error, too high or too low, exceeds the height of a
/// layer, or the error at the top would exceed half of that height.
bool needsReplanning(const PartUnderWay& part, double layer_mm, const LayerAuthority& authority);

/// The heights of the layers left, scaled by one factor so that the part ends at its planned top. If that
/// factor is outside 0.7 to 1.3, or a height outside the window of the process, the number of layers changes
/// instead. All layers then have one height, which may differ from the planned mean by the same factors.
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

/// The action in a region of a layer.
enum class RegionStep { None, AddLayer, SkipLayer, FillBeads };

/// The decision on a stretch: consecutive cells with an error above 0.75 layer heights, all too low or all
/// too high.
struct RegionDecision {
  RegionStep step = RegionStep::None;
  std::size_t run = 0;    ///< number in `LayerCells::runs`
  std::size_t first = 0;  ///< number of the stretch's first cell in the layer
  /// Number of cells; on a closed run the stretch may continue from the run's last cell to its first.
  std::size_t count = 0;
};

/// The decisions on all stretches on which something changes. On a stretch of at least three bead widths a
/// whole layer is added or left out. A shorter dip is filled by beads of its own; a shorter bump stays.
std::vector<RegionDecision> regionDecisions(const LayerCells& cells, const std::vector<double>& error_mm);

}  // namespace lamina
