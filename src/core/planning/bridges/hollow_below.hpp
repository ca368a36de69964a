// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/skins/layer_cover.hpp"
#include "planning/skins/skin_areas.hpp"

namespace lamina {

/// Areas of a layer above a layer that is hollow within its walls and skins.
struct HollowBelow {
  Regions room;      ///< area within the walls that is not hollow in both layers
  Regions carrying;  ///< walls and skins of the layer below, and its material beyond these walls
  Regions hollow;    ///< area that is hollow in both layers, without narrow places
};

/// The areas of `HollowBelow`, for a part without infill. `room` is empty if no skin of the layer lies over a
/// hollow.
/// @param inside  area within the walls of the layer, taken to be the same in the layer below
HollowBelow hollowBelow(const Regions& inside, const LayerCover& cover, const LayerCover& cover_below,
                        const SkinMeasures& measures);

}  // namespace lamina
