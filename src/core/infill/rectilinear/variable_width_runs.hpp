// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Plan width of the narrowest bead of a solid raster [mm].
double narrowestBead(const InfillRequest& request);

/// Fills an area solidly by a zigzag. Each region is divided evenly into variable-width lines parallel to the
/// raster. A bead fills each line from end to end, as wide as the line is at each point, and links along the
/// border join the beads. Runs are in the order of `raster.order`, beginning at `request.start`; with
/// `LineAdvance::OneSense` this order must be kept.
///
/// Centre lines stay inside the area, except beside spikes of the border narrower than a variable-width line,
/// where they may leave it by half the narrowest bead.
///
/// @param links  the area shrunk by half the narrowest bead, along whose outlines links run
std::vector<FillPath> variableWidthRuns(const Regions& links, const InfillRequest& request);

/// The same in any sense, with links that go to the border and back: between perimeters the beads that were
/// widened instead would lap over by more than 3 % in layers of narrow areas.
std::vector<FillPath> variableWidthRunsWithJogs(const Regions& links, const InfillRequest& request);

}  // namespace lamina
