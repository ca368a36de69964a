// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/planning/order/anchoring.hpp"
#include "lamina/planning/supports/support_settings.hpp"
#include "lamina/slicing/layer.hpp"

namespace lamina {

/// The height of the layer amid the part [mm], of which there is one at least.
double heightAmid(const std::vector<Layer>& layers);

/// How many layers lie between the first layer of an inclined part and the lowest place where what falls from
/// the part, along gravity, meets the bed. Zero for a part whose first layer is that place, and for no part.
/// @param layers  of the part, in their frame
std::size_t countLayersBelow(const std::vector<Layer>& layers, const BedPlane& bed,
                             const SupportSettings& settings);

/// The layers with as many empty ones before the first, as high as those amid the part.
std::vector<Layer> withLayersBelow(const std::vector<Layer>& layers, std::size_t count);

}  // namespace lamina
