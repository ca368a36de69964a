// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/order/anchoring.hpp"
#include "lamina/planning/skins/layer_cover.hpp"
#include "lamina/slicing/layer.hpp"

namespace lamina {

/// The material of layers in parallel planes, in their frame, and the direction of gravity there.
struct StackedMaterial {
  std::vector<SharedRegions> material;  ///< of each layer; layers that equal the one before share its regions
  std::vector<LayerBounds> bounds;
  std::optional<BedPlane> bed;  ///< below inclined layers
  Box2 box;                     ///< bounding box of all material

  std::size_t size() const { return material.size(); }
  /// Shift of a vertical line in the plane of the layers, per millimetre down their normal. Zero in level
  /// layers.
  Point2 fall() const;
  /// The area of the bed, near the model, that lies in the plane half way up a layer. Empty in level layers.
  Regions bedIn(std::size_t layer) const;
};

/// Collects the material of layers.
/// @param tolerance_mm  by which outlines are simplified
StackedMaterial stackedMaterial(const std::vector<Layer>& layers, double tolerance_mm,
                                const std::optional<BedPlane>& bed, Progress& progress);

/// The union of both; one of them unchanged if the other is empty.
Regions united(const Regions& a, const Regions& b);

/// The regions with fewer points, and without areas below 1e-6 mm².
Regions simplified(const Regions& regions, double tolerance_mm);

/// The regions clipped to a box that is grown by `reach_mm` on each side. Outlines may touch themselves along
/// its sides. Operations with at most that reach give the same result within the box itself as on the whole
/// regions.
Regions within(const Regions& regions, const Box2& box, double reach_mm);

/// The bounding box of all outlines.
Box2 boxOf(const Regions& regions);

/// The regions without those that are narrower than `narrowest_mm` everywhere.
Regions withoutNarrowPieces(Regions regions, double narrowest_mm);

/// The regions without places narrower than `narrowest_mm`.
Regions withoutNarrow(const Regions& regions, double narrowest_mm);

}  // namespace lamina
