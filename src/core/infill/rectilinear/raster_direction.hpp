// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// The number of passes of a raster times its spacing [mm], averaged over positions of the lines: half the
/// total length of the outlines as projected across the lines. For a convex region this is its width across
/// the lines.
double extentAcross(const Regions& regions, double angle_rad);

/// The direction in [0, pi) with the least `extentAcross`, and so with the fewest passes and turns. Between
/// the directions of two edges it has no minimum, so that the result is the direction of an edge (for a
/// convex region as by rotating calipers), or `angle_rad` itself if none is better. Takes time of order n log
/// n.
double angleOfFewestTurns(const Regions& regions, double angle_rad);

/// The fill in the direction that `raster.direction` asks for. Fewest turns: `angleOfFewestTurns`. Least
/// travel: of several candidates the direction with the shortest travel from `request.start` to the runs and
/// between them, in whole spacings; of equal ones the one with fewer turns. Candidates are the direction of
/// fewest turns, 12 evenly spaced directions from the given one on, and then steps from the best one, halved
/// four times.
std::vector<FillPath> inBestDirection(const Regions& regions, const InfillRequest& request,
                                      const FillFunction& fill);

}  // namespace lamina
