// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Turns the loops of the layers from `first` on into one wall that rises steadily. Each layer has one
/// counter-clockwise loop.
///
/// Along a loop the nozzle rises from the bottom to the top of its layer, in proportion to the length. Seen
/// from above, each point is shifted towards the loop below, in proportion to the remaining length: there is
/// no step between loops. The bead is as high as the nozzle is above the turn below. The first turn therefore
/// grows from height 0 on the flat layer below. After the last one the nozzle goes round once more at the
/// top, where the bead shrinks to height 0.
///
/// Layers without a loop may only follow the last one with a loop. Skirts stay; travels between layers are
/// not made here.
/// @throws InvalidInput naming the layer that has several regions, a hole, or no room for the bead, or if no
///   layer holds a loop
void raiseWall(std::vector<ToolpathLayer>& layers, std::size_t first, const TravelSettings& travel);

}  // namespace lamina
