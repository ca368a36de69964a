// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Makes one wall that rises all the time of the loops of the layers from `first` on, each of which holds one
/// counter-clockwise loop.
///
/// Along a loop of length L the nozzle rises from the bottom of its layer to the top, in proportion to the
/// way. Seen from above, the loop begins on that of the layer below and ends on its own, so that there is
/// no step between two: each point is drawn towards the loop below by the part of the loop that is still to
/// come. The bead is as high as the nozzle is above the turn below. The first turn thus grows from nothing
/// on what is flat below it; after the last one the nozzle goes round once more at the top, where the bead
/// shrinks to nothing.
///
/// Layers that hold no loop may only follow the last one that does. Skirts stay; travels between layers are
/// not made here.
/// @throws InvalidInput naming the layer that has several regions, a hole, or no room for the bead, or if no
///         layer holds a loop
void raiseWall(std::vector<ToolpathLayer>& layers, std::size_t first, const TravelSettings& travel);

}  // namespace lamina
