// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// What a bridge is measured with [mm].
struct BridgeSearch {
  double anchor_mm = 1.0;   ///< threads need half of it on what holds them
  double pitch_mm = 0.36;   ///< of threads
  double least_held = 0.5;  ///< the search ends early where no direction can reach it
};

/// How the threads over a piece lie.
struct BridgeDirection {
  double angle_rad = 0.0;  ///< from x, within [0, pi)
  double held = 0.0;       ///< share of the threads' length in the piece that is held at both ends
  double span_mm = 0.0;    ///< longest way of a held thread over nothing, beyond the piece too
};

/// The best direction of threads over a piece that lies over nothing: that in which most of their length is
/// held at both ends; of those within 0.03 of it, the one of the shortest free span. Tried are the directions
/// of the piece's edges, of the chords between the ends of what holds its border, and every 5 deg; those
/// within 1 deg of each other are one.
/// @param piece  [mm]; without area nothing is held
/// @param below  material of the layer below, near the piece: does not overlap it
BridgeDirection bridgeDirection(const Region& piece, const Regions& below, const BridgeSearch& search);

/// The same in a given direction.
BridgeDirection bridgeAlong(double angle_rad, const Region& piece, const Regions& below,
                            const BridgeSearch& search);

}  // namespace lamina
