// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/planning/plan_settings.hpp"
#include "lamina/slicing/adapted/adapted_layers.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Paths along adapted curves, one bead per wall. Beads are outer walls of width `bead.width_mm`; their
/// height at each waypoint is that of the curve. The tool axis is opposite to the curve's axis; the nozzle is
/// rotated from straight down by the least angle. Beads lie inside the wall by `walls.contour_offset` of
/// their width, along the wall's normal; in the lowest layer horizontally. Nothing is deposited where the
/// wall is thinner than twice that distance. Loops start as `seam.*` says, in random placement at the point
/// nearest to the seam; open curves start at the end nearer to the nozzle. Layers are joined by travels.
///
/// @return `z_mm` is the highest point of a layer, `height_mm` its greatest height; layers on which nothing
///   is deposited are left out
/// @throws InvalidInput if nothing is deposited on any layer that has curves
std::vector<ToolpathLayer> adaptedWalls(const AdaptedLayers& layers, const PlanSettings& settings);

}  // namespace lamina
