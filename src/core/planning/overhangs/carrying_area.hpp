// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/order/anchoring.hpp"
#include "lamina/planning/skins/layer_cover.hpp"
#include "lamina/slicing/layer.hpp"

namespace lamina {

/// The area that supports a layer along the tool axis, in its plane: the material of the layer below, and in
/// inclined layers the strip along which the layer stands on the bed.
Regions carryingArea(const Layer& layer, const LayerCover& cover, const std::optional<BedPlane>& bed);

/// Whether a layer is known to be supported as a whole without computation: it equals the one below, or
/// stands on the bed.
bool isCarried(const LayerCover& cover, const std::optional<BedPlane>& bed, std::size_t index);

}  // namespace lamina
