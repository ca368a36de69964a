// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Parameters of the search for a bridge's direction.
struct BridgeSearch {
  double anchor_mm = 1.0;   ///< length of threads on the material below; half of it suffices to hold an end
  double pitch_mm = 0.36;   ///< distance of neighbouring threads
  double least_held = 0.5;  ///< the search ends early if no direction can reach this share
};

/// A direction of the threads over a piece, and how well they are held.
struct BridgeDirection {
  double angle_rad = 0.0;  ///< angle of the threads from x, within [0, pi)
  double held = 0.0;  ///< share of all threads' length in the piece that belongs to threads held at both ends
  double span_mm = 0.0;  ///< longest free span of a held thread, beyond the piece too
};

/// The best direction of threads over an unsupported piece: the direction with the greatest share of length
/// held at both ends. Among directions whose share is within 0.03 of the greatest, it is the direction with
/// the shortest free span. Candidates are the directions of the piece's edges, the directions of chords
/// between the ends of the border's held parts, and directions every 5 deg. Candidates within 1 deg of each
/// other count as one.
/// @param piece  [mm]; without area no length is held
/// @param below  material of the layer below, near the piece; does not overlap the piece
BridgeDirection bridgeDirection(const Region& piece, const Regions& below, const BridgeSearch& search);

/// The given direction, and how well threads along it are held.
/// @param angle_rad  angle of the threads from x
BridgeDirection bridgeAlong(double angle_rad, const Region& piece, const Regions& below,
                            const BridgeSearch& search);

}  // namespace lamina
