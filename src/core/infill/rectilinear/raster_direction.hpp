// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// The number of passes of a raster times its spacing, on the average over where its lines lie: half the way
/// that the outlines go across the lines. For a convex region its width across them [mm].
double extentAcross(const Regions& regions, double angle_rad);

/// The direction in which `extentAcross` is least, within [0, pi), and with it the number of passes and of
/// turns. Between the directions of two edges it has no minimum, so that one of the edges has the direction
/// (for a convex region as by rotating calipers). `angle_rad` itself if no other is better. n log n time.
double angleOfFewestTurns(const Regions& regions, double angle_rad);

/// The fill in the direction that `raster.direction` asks for. Fewest turns: as above. Least travel: of the
/// direction of fewest turns, 12 that are evenly spread from the one given, and then steps from the best one
/// that halve four times, that with the shortest way from `request.start` to the runs and between them, in
/// whole spacings; of several the one of fewer turns.
std::vector<FillPath> inBestDirection(const Regions& regions, const InfillRequest& request,
                                      const FillFunction& fill);

}  // namespace lamina
