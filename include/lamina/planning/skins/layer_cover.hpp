// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/plan_settings.hpp"

namespace lamina {

/// Regions that layers share if they are equal. Never null.
using SharedRegions = std::shared_ptr<const Regions>;

/// The material of one layer and what covers it, in the frame of the layers.
struct LayerCover {
  SharedRegions material;
  SharedRegions above;  ///< the next layer; empty above the last one
  SharedRegions below;  ///< the layer before; empty below the first one
  SharedRegions whole;  ///< material in all layers that skins consider, above and below

  /// Whether no part of the layer is visible.
  bool isCovered() const { return whole == material; }
};

/// Whether layers are divided into skins and a sparse infill between their walls: skins are asked for, and
/// the infill is sparse, of beads, and stays in its layer.
bool takesSkins(const PlanSettings& settings);

/// Number of layers in a skin if all have the same height: the greater of the number asked for and the number
/// that reaches the thickness.
std::size_t skinCount(int layers, double thickness_mm, double layer_height_mm);

/// The cover, moved in the plane of the layers [mm].
LayerCover moved(const LayerCover& cover, const Point2& by);

/// The cover of each layer. Equal layers share their regions and cost nothing. Any other layer costs a few
/// intersections, independent of the number of skin layers, by a window that slides over the stack.
/// @param material    material of each layer, from the bottom
/// @param heights_mm  height of each layer
/// @return one per layer; the same for any number of threads
std::vector<LayerCover> coversOf(std::vector<Regions> material, const std::vector<double>& heights_mm,
                                 const SkinSettings& settings, Progress& progress);

}  // namespace lamina
