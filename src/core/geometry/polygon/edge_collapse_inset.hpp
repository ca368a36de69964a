// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// The region shrunk by `distance_mm` with mitred reflex corners, by moving each edge inwards on its own.
/// This is many times as fast as clipping, but does not detect where parts of the outline meet. Nothing if
/// they do or might meet, or if a corner would need a mitre of more than twice the distance.
///
/// Why a result is correct: each edge sweeps a cell, between its old and its new position, and all cells are
/// wound like the region. The winding number of the moved outlines at a point is therefore that of the region
/// less the number of cells that cover the point. Only points of the region in no cell have winding number
/// one. These form a region if the moved outlines are simple, do not meet, and nest. The cell of an edge that
/// vanishes between two others is the triangle up to the point at which the two neighbours meet. This point
/// must lie at least `distance_mm` from the edge; it may be nearer if one neighbour turns away, as the edge
/// then vanishes behind the area that the other neighbour sweeps. There is no result if the other neighbour
/// has become too short to hide the edge, as a corner would then lie nearer than `distance_mm` to a moved
/// edge. The mitre at a corner beside a vanished edge ends with that edge. Mitres of clipping do not end
/// there, so that clipping removes slivers farther than `distance_mm` from the outline, which remain here.
///
/// @param region  with winding number one or zero at every point, as all functions of `offset.hpp` return it
std::optional<Region> insetByEdgeCollapse(const Region& region, double distance_mm);

}  // namespace lamina
