// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/fill_path.hpp"

namespace lamina {

/// Direction, pitch and anchor of a bridge's threads.
struct ThreadLayout {
  double angle_rad = 0.0;
  double pitch_mm = 0.36;  ///< adapted slightly so that threads fill the piece
  double anchor_mm = 1.0;  ///< length of threads on the material that holds them
};

/// Straight threads side by side over an unsupported piece. Each extends onto the layer below by the anchor;
/// where that layer ends earlier at another gap, to the middle between the two gaps. All stay within the
/// walls. Neighbours that end beside each other, at least a spacing on what holds them, are joined there to a
/// run to and fro. Joined ends are cut by half a spacing, so that the run deposits as much as they would.
/// @param piece   [mm]
/// @param below   material of the layer below: does not overlap the piece
/// @param inside  walls
std::vector<FillPath> bridgeThreads(const Region& piece, const Regions& below, const Regions& inside,
                                    const ThreadLayout& layout);

/// The area that threads in that direction cover: the piece, extended by the anchor within the walls.
Regions coveredByThreads(const Region& piece, const Regions& inside, const ThreadLayout& layout);

}  // namespace lamina
