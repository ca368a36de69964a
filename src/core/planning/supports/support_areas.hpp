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

/// The part of a layer's support between two heights [mm, frame of the layers].
struct SupportSection {
  double bottom_mm = 0.0;
  double top_mm = 0.0;
  SharedRegions lattice;
  SharedRegions interface;  ///< dense area; does not overlap the lattice
};

/// The support of one layer, lowest section first: one as high as the layer, and lower ones where columns end
/// in it. Empty without support.
using LayerSupport = std::vector<SupportSection>;

/// The support of all layers, and its totals.
struct SupportAreas {
  std::vector<LayerSupport> layers;
  SupportTotals totals;  ///< without volumes
};

/// The last layers of columns that end at a gap below a layer.
struct ColumnTop {
  struct Cap {
    std::size_t layer = 0;
    double bottom_mm = 0.0;
    double top_mm = 0.0;
  };
  std::size_t full_layers = 0;  ///< number, from the bed up, of layers as high as those of the part
  std::vector<Cap> caps;  ///< up to two lower layers on top, at least half a layer high except on the bed
};

/// The top of columns that leaves exactly the gap below a layer. The rest of the layer in which they end is a
/// lower layer of support; if it is less than half a layer, it is shared out with the layer below.
/// @return none if there is no room for support
std::optional<ColumnTop> columnTopBelow(const std::vector<LayerBounds>& bounds, std::size_t layer,
                                        double gap_mm);

/// Some of the layers of a stack.
struct LayerSpan {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Overhangs by layer, and the range of layers over which totals are taken.
struct CountedOverhangs {
  const std::vector<Regions>& areas;
  LayerSpan counted;
};

/// Columns below overhangs, from the top down: `F(j) = (F(j+1) + C) \ R(j)`. C are the overhangs whose
/// columns end in layer j, and R(j) is the part, grown by the side gap. In inclined layers columns follow
/// gravity. In level layers they come as near as `ledgeGap` below walls that overhang within the side gap.
/// The cost is one union and one difference for each layer that differs from the one above.
SupportAreas supportAreas(const StackedMaterial& stack, const CountedOverhangs& overhangs,
                          const SupportSettings& settings, const WallBeads& walls, Progress& progress);

}  // namespace lamina
