// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/planning/order/anchoring.hpp"
#include "lamina/planning/supports/support_settings.hpp"
#include "lamina/slicing/layer.hpp"

namespace lamina {

/// Height of the layer in the middle of a list that is not empty [mm].
double heightAmid(const std::vector<Layer>& layers);

/// Number of layers between the first layer of an inclined part and the lowest point at which supports,
/// extended from the part along gravity, meet the bed. Zero if the first layer lies at that point, and
/// without layers.
/// @param layers  of the part, in their frame
std::size_t countLayersBelow(const std::vector<Layer>& layers, const BedPlane& bed,
                             const SupportSettings& settings);

/// The layers, preceded by `count` empty layers of height `heightAmid`.
std::vector<Layer> withLayersBelow(const std::vector<Layer>& layers, std::size_t count);

}  // namespace lamina
