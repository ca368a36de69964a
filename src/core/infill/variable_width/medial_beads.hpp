// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/fill_path.hpp"

namespace lamina {

/// How narrow regions are filled along their medial axis. T is the local thickness, twice the clearance.
struct MedialBeadSettings {
  double pitch_mm = 0.4;      ///< plan width of a nominal bead
  double least_width = 0.3;   ///< in pitches: where T is less, nothing is deposited
  double widest_bead = 1.6;   ///< in pitches: up to this T one bead fills, then two up to one pitch more, ...
  double least_length = 0.5;  ///< in pitches: shorter runs that branch off others are left out
};

/// Open runs (closed where the axis is) of role GapFill along the medial axes of the regions, as few as go
/// straight on where branches meet. One bead is T wide; n beads side by side are T / n wide each. Ends keep
/// half their width from the border. Regions of no area, and what is thinner than the least width, give no
/// run.
/// @throws InvalidInput if the pitch is not positive
std::vector<FillPath> medialBeads(const Regions& regions, const MedialBeadSettings& settings);

/// Closed runs out and back round each connected axis, T / 2 wide on each side of it, however thick the
/// region: one run, and one more for each hole that the axis goes round. Counter-clockwise round the axis.
/// @throws InvalidInput if the pitch is not positive
std::vector<FillPath> medialLoops(const Regions& regions, const MedialBeadSettings& settings);

}  // namespace lamina
