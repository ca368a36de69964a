// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon/polygon.hpp"
#include "planning/skins/layer_cover.hpp"
#include "planning/skins/skin_areas.hpp"

namespace lamina {

/// A layer over one that is hollow within its walls and skins.
struct HollowBelow {
  Regions room;      ///< within the walls, without what is hollow in both
  Regions carrying;  ///< walls and skins of the layer below, and whatever it has beyond these walls
  Regions hollow;    ///< in both, but for narrow places
};

/// What lies below an area of a part without infill. No room if the area has no skin over a hollow.
/// @param inside  walls, of the layer; those of the layer below are taken to be the same
HollowBelow hollowBelow(const Regions& inside, const LayerCover& cover, const LayerCover& cover_below,
                        const SkinMeasures& measures);

}  // namespace lamina
