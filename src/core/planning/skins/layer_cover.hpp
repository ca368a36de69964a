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

/// Regions that several layers share where they are the same. Never null.
using SharedRegions = std::shared_ptr<const Regions>;

/// The material of one layer and what covers it, in the frame of the layers.
struct LayerCover {
  SharedRegions material;
  SharedRegions above;  ///< the next layer; empty above the last one
  SharedRegions below;  ///< the layer before; empty below the first one
  SharedRegions whole;  ///< what is material in all the layers that skins count, above and below

  /// Whether nothing of the layer is seen.
  bool isCovered() const { return whole == material; }
};

/// The same elsewhere in the plane of the layers.
LayerCover moved(const LayerCover& cover, const Point2& by);

/// What covers each layer. Layers that are the same share their regions, and cost nothing; the others a few
/// intersections each, however many layers a skin has: windows slide over the stack.
/// @param material    of each layer, from the bottom
/// @param heights_mm  of each layer
/// @return as many as layers; the same for any number of threads
std::vector<LayerCover> coversOf(std::vector<Regions> material, const std::vector<double>& heights_mm,
                                 const SkinSettings& settings, Progress& progress);

}  // namespace lamina
