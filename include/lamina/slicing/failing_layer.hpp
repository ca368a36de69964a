// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace lamina {

/// A layer as errors name it: "layer 12 at 2.4 mm".
/// @param layer   index, from 0, as in `;LAYER:`
/// @param top_mm  where the nozzle's tip runs, in the frame of the layers
std::string layerPlace(std::size_t layer, double top_mm);

/// An island of it: "layer 12 at 2.4 mm, island 3".
/// @param island  index in its layer, from 0
std::string islandPlace(std::size_t layer, double top_mm, std::size_t island);

}  // namespace lamina
