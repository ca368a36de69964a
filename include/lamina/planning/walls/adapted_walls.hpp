// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/planning/plan_settings.hpp"
#include "lamina/slicing/adapted/adapted_layers.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Paths along adapted curves, one bead per wall. Beads are outer walls of the set width, at each waypoint as
/// high as the curve is above the one below. The tool axis is opposite to the curve's axis; the nozzle is
/// rotated by the shortest way from straight down. Beads lie `walls.contour_offset` of their width inside the
/// wall, along its normal; where the wall is too thin for that from both of its sides, nothing is deposited.
/// Loops start as `seam.*` says, in random placement at the point nearest to the seam; open curves start at
/// the end nearer to the nozzle. Layers are joined by travels.
///
/// @return `z_mm` is the highest point of a layer, `height_mm` its greatest height; layers on which nothing
///   is deposited are left out
/// @throws InvalidInput if nothing is deposited on any layer that has curves
std::vector<ToolpathLayer> adaptedWalls(const AdaptedLayers& layers, const PlanSettings& settings);

}  // namespace lamina
