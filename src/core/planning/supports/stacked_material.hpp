// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/order/anchoring.hpp"
#include "lamina/slicing/layer.hpp"
#include "planning/skins/layer_cover.hpp"

namespace lamina {

/// What layers in parallel planes are made of, in their frame, and which way things fall there.
struct StackedMaterial {
  std::vector<SharedRegions> material;  ///< of each layer; layers that equal the one before share its regions
  std::vector<LayerBounds> bounds;
  std::optional<BedPlane> bed;  ///< below inclined layers
  Box2 box;                     ///< round all of it

  std::size_t size() const { return material.size(); }
  /// In the plane of the layers, for each millimetre down along their normal. Zero in level layers.
  Point2 fall() const;
  /// What of the plane half way up a layer lies in the bed, near the part. Nothing in level layers.
  Regions bedIn(std::size_t layer) const;
};

/// @param tolerance_mm  by which outlines are simplified
StackedMaterial stackedMaterial(const std::vector<Layer>& layers, double tolerance_mm,
                                const std::optional<BedPlane>& bed, Progress& progress);

/// What either is; one of them as it is if the other is empty.
Regions united(const Regions& a, const Regions& b);

/// The outlines with fewer points, and without areas below a millionth of a square millimetre.
Regions simplified(const Regions& regions, double tolerance_mm);

/// What of them lies within a box that is larger by `reach_mm` all round. Along its sides outlines may touch
/// themselves: within the box itself what is made of them, up to that reach, is as if made of the whole.
Regions within(const Regions& regions, const Box2& box, double reach_mm);

/// Round all outlines.
Box2 boxOf(const Regions& regions);

/// Without regions that are narrower than that all over.
Regions withoutNarrowPieces(Regions regions, double narrowest_mm);

/// Without what is narrower than that.
Regions withoutNarrow(const Regions& regions, double narrowest_mm);

}  // namespace lamina
