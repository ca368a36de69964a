// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/supports/support_settings.hpp"

namespace lamina {

/// The walls of a part.
struct WallBeads {
  double width_mm = 0.0;      ///< width of a bead; narrower places have no support
  double thickness_mm = 0.0;  ///< thickness of all walls together; 0 without walls
};

/// Least gap between the part and the side of a support, used below ledges: equal to the gap above a support,
/// but at most `supports.side_gap_mm`.
double ledgeGap(const SupportSettings& settings);

/// Greatest widening of a column from layer to layer on each side, at which half a bead is unsupported.
double ledgeStep(const WallBeads& walls);

/// Walls over nothing: beads with more than three quarters of their width beyond the layer below, on
/// stretches longer than three bead widths.
/// @param overhang  of the layer, as far as it is supported
/// @param layer     whole area of the layer
/// @return empty without walls
Regions hangingWalls(const Regions& overhang, const Regions& layer, const WallBeads& walls);

/// The stretches of hanging walls that come within a distance of the part, if they are at least three beads
/// long.
/// @param hanging  result of `hangingWalls`
/// @param below    area of the part next to the end of the supports
Regions nearPart(const Regions& hanging, const Regions& below, double distance_mm, const WallBeads& walls);

/// Ledges: places where walls overhang within the side gap, out of reach of a column that keeps this gap. A
/// ledge consists of beads with more than three quarters of their width beyond the part, on a stretch longer
/// than three bead widths, and of the area round them that makes a column one bead wide beyond the gap.
/// @param overhang  of the layer, as far as it is supported
/// @param layer     whole area of the layer
/// @param below     area of the part beside the end of the columns
/// @return empty without ledges, or if the side gap is no wider than `ledgeGap`
Regions ledgesIn(const Regions& overhang, const Regions& layer, const Regions& below, const WallBeads& walls,
                 const SupportSettings& settings);

}  // namespace lamina
