// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// The region shrunk by `distance_mm` with mitred reflex corners, by moving each edge inwards by itself: many
/// times as fast as clipping, but it does not see where parts of the outline meet. None where that happens or
/// might happen, and where a corner would need more than a mitre of twice the distance.
///
/// Why the result is right where there is one: each edge sweeps a cell, between where it was and where it
/// arrives, and all cells are wound as the region is. So the moved outlines wind round a point once less than
/// the region for each cell that covers it: exactly the points of the region in no cell are wound round once,
/// and they bound a region if they are simple, do not meet, and nest. An edge that vanishes between two
/// others has a triangle to where those meet for its cell, which must lie at least `distance_mm` from it; or
/// nearer, if one of the two turns away from it: then it vanishes behind what that one sweeps. None where
/// that one has become too short to hide it: a corner would lie nearer than `distance_mm` to a moved edge.
/// The mitre of a corner beside a vanished edge ends with that edge. Mitres of clipping do not: it takes away
/// slivers that stay here, farther than `distance_mm` from the outline.
///
/// @param region  winds round each point once or not at all, as all functions of `offset.hpp` return them
std::optional<Region> insetByEdgeCollapse(const Region& region, double distance_mm);

}  // namespace lamina
