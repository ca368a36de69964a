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

/// Straight threads side by side over an unsupported piece. Each extends onto the layer below by the anchor.
/// If another gap is nearer than the anchor, the thread ends midway between the gaps. All stay within the
/// walls. Neighbouring threads are joined into one zigzag run if their ends are adjacent and rest on at least
/// one spacing of material. Joined ends are cut by half a spacing: the run deposits the volume of the
/// separate threads.
/// @param piece   [mm]
/// @param below   material of the layer below: does not overlap the piece
/// @param inside  walls
std::vector<FillPath> bridgeThreads(const Region& piece, const Regions& below, const Regions& inside,
                                    const ThreadLayout& layout);

/// The area that the threads cover: the piece, extended by the anchor within the walls.
Regions coveredByThreads(const Region& piece, const Regions& inside, const ThreadLayout& layout);

}  // namespace lamina
