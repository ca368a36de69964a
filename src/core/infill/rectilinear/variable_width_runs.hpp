// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Plan width of the narrowest bead of a solid raster [mm].
double narrowestBead(const InfillRequest& request);

/// Fills an area solidly by a zigzag: variable-width lines parallel to the raster divide each region evenly,
/// a bead fills each line to its ends, as wide as the line is there, and links along the border join the
/// beads. Runs are in the order of `raster.order`, from `request.start` on; in that of
/// `LineAdvance::OneSense` they are to stay as they are.
///
/// Centre lines stay inside the area; beside spikes of the border narrower than a variable-width line they
/// may leave it by half the narrowest bead.
///
/// @param links  the area, shrunk by half the narrowest bead: where links along the border run
std::vector<FillPath> variableWidthRuns(const Regions& links, const InfillRequest& request);

}  // namespace lamina
