// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/planning/planner.hpp"
#include "lamina/planning/supports/support_settings.hpp"
#include "planning/supports/ledges.hpp"
#include "planning/supports/stacked_material.hpp"

namespace lamina {

/// Support of one height in a layer [frame of the layers].
struct SupportSection {
  double bottom_mm = 0.0;
  double top_mm = 0.0;
  SharedRegions lattice;
  SharedRegions interface;  ///< dense; beside the lattice
};

/// Of one layer, the lowest first: one as high as the layer, and lower ones where columns end in it. None
/// without support.
using LayerSupport = std::vector<SupportSection>;

/// Support of all layers, and its areas.
struct SupportAreas {
  std::vector<LayerSupport> layers;
  SupportTotals totals;  ///< without volumes
};

/// The last layers of columns that end a gap below a layer.
struct ColumnTop {
  struct Cap {
    std::size_t layer = 0;
    double bottom_mm = 0.0;
    double top_mm = 0.0;
  };
  std::size_t full_layers = 0;  ///< from the bed up, as high as those of the part
  std::vector<Cap> caps;        ///< on them, none or up to two: at least half as high, but on the bed
};

/// Where columns below a layer end so that the gap to it is met exactly. What is left of the layer in which
/// they end is a lower layer of support; less than half of it is shared out with the layer below.
/// @return none if no support has room
std::optional<ColumnTop> columnTopBelow(const std::vector<LayerBounds>& bounds, std::size_t layer,
                                        double gap_mm);

/// Some of the layers of a stack.
struct LayerSpan {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// What hangs over, by layer, and the layers that totals are of.
struct CountedOverhangs {
  const std::vector<Regions>& areas;
  LayerSpan counted;
};

/// Columns below what hangs over, from the top down: `F(j) = (F(j+1) + C) \ R(j)`, where C is what is held up
/// by columns that end in layer j, without what is nearer to the part R(j) than the side gap. In inclined
/// layers columns fall along gravity. In level ones columns come as near as `ledgeGap` below walls that would
/// hang within the side gap. One union and one difference for each layer that is not as the one above it.
SupportAreas supportAreas(const StackedMaterial& stack, const CountedOverhangs& overhangs,
                          const SupportSettings& settings, const WallBeads& walls, Progress& progress);

}  // namespace lamina
