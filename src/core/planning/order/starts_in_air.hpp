// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/order/anchoring.hpp"
#include "lamina/slicing/layer.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/order/support_test.hpp"

namespace lamina {

/// Inclined layers as sliced, and the supports below them.
struct CarriedLayers {
  const std::vector<Layer>& layers;
  const std::vector<Regions>& supports;  ///< below each layer, carried up to it; none if empty
  const BedPlane& bed;
  double bead_width_mm = 0.0;
};

/// Places where runs begin in the air, by layer [mm].
using StartsInAir = std::vector<std::vector<Point2>>;

/// Runs of beads that begin with neither bed, support nor the layer before below them. Runs that continue
/// where the run before ended are not among them.
/// @param toolpath  the plan of the layers, in their frame
StartsInAir startsInAir(const CarriedLayers& carried, const std::vector<ToolpathLayer>& toolpath);

std::size_t countOf(const StartsInAir& starts);

/// The support test of a layer.
SupportTest supportTestOf(const CarriedLayers& carried, std::size_t index);

/// The gap between the bed and the lowest bead of the first layer with beads or drops of the part [mm]. Zero
/// if the bed or a support carries any waypoint of that layer, and for a toolpath without the part.
double gapBelowPart(const CarriedLayers& carried, const std::vector<ToolpathLayer>& toolpath);

}  // namespace lamina
