// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/fill_path.hpp"

namespace lamina {

/// How the threads of a bridge lie.
struct ThreadLayout {
  double angle_rad = 0.0;
  double pitch_mm = 0.36;  ///< taken a little closer or wider, so that threads fill the piece
  double anchor_mm = 1.0;  ///< by which threads go on over what holds them
};

/// Straight threads over a piece that lies over nothing, side by side. Each goes on over the layer below by
/// the anchor, as far as there is any without a gap: where another gap follows, to the middle of what lies
/// between. All keep within the walls.
/// @param piece   [mm]
/// @param below   material of the layer below: does not overlap the piece
/// @param inside  walls
std::vector<FillPath> bridgeThreads(const Region& piece, const Regions& below, const Regions& inside,
                                    const ThreadLayout& layout);

/// What threads in that direction cover: the piece, drawn out by the anchor within the walls.
Regions coveredByThreads(const Region& piece, const Regions& inside, const ThreadLayout& layout);

}  // namespace lamina
