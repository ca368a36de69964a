// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/order/anchoring.hpp"
#include "lamina/slicing/layer.hpp"
#include "planning/skins/layer_cover.hpp"

namespace lamina {

/// What carries a layer along the tool axis, in its plane: the material of the layer below, and in inclined
/// layers the strip along which the layer stands on the bed.
Regions carryingArea(const Layer& layer, const LayerCover& cover, const std::optional<BedPlane>& bed);

/// Whether the layer below carries all of a layer, as far as can be seen without looking: the two are the
/// same, or it stands on the bed.
bool isCarried(const LayerCover& cover, const std::optional<BedPlane>& bed, std::size_t index);

}  // namespace lamina
