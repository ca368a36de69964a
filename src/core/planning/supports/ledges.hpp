// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/supports/support_settings.hpp"

namespace lamina {

/// The walls of a part.
struct WallBeads {
  double width_mm = 0.0;      ///< of one bead; narrower places have no support
  double thickness_mm = 0.0;  ///< of all of them, from the outline in; 0 without walls
};

/// Between the part and a support where that comes nearest to it: what is left above a support is left beside
/// it too, below a ledge. No more than `supports.side_gap_mm`.
double ledgeGap(const SupportSettings& settings);

/// By how much a column may be wider than the layer of it below, on each side: half a bead lies on nothing.
double ledgeStep(const WallBeads& walls);

/// Where walls hang within the side gap, out of reach of a column that keeps it: beads of which more than
/// three quarters lie beyond the part, on stretches longer than three of their widths; and round them what
/// a column needs to be as wide as a bead beyond the gap.
/// @param overhang  of the layer: what supports hold up
/// @param layer     all of it
/// @param below     of the part beside the end of the columns
/// @return nothing without ledges, and where the gap is no wider than the least
Regions ledgesIn(const Regions& overhang, const Regions& layer, const Regions& below, const WallBeads& walls,
                 const SupportSettings& settings);

}  // namespace lamina
