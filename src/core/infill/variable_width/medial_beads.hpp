// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/infill/fill_path.hpp"

namespace lamina {

/// How narrow regions are filled along their medial axis. T is the local thickness, twice the clearance.
struct MedialBeadSettings {
  double pitch_mm = 0.4;     ///< plan width of a nominal bead
  double least_width = 0.3;  ///< in pitches: least T at which anything is deposited
  /// In pitches: greatest T that one bead fills; two beads fill up to one pitch more, and so on.
  double widest_bead = 1.6;
  double least_length = 0.5;  ///< in pitches: shorter runs that branch off others are left out
};

/// Open runs (closed if the axis is) of role GapFill along the medial axes of the regions. Where branches
/// meet, the straightest continuations are joined, so that runs are few. One bead is T wide; n beads side by
/// side are T / n wide each. Ends keep half their width from the border. Regions without area, and those
/// thinner than the least width, have no run.
/// @throws InvalidInput if the pitch is not positive
std::vector<FillPath> medialBeads(const Regions& regions, const MedialBeadSettings& settings);

/// Closed runs around each connected axis, T / 2 wide on each side of the axis, however thick the region: one
/// run around the outside, and one more for each hole that the axis encloses. Counter-clockwise around the
/// axis.
/// @throws InvalidInput if the pitch is not positive
std::vector<FillPath> medialLoops(const Regions& regions, const MedialBeadSettings& settings);

}  // namespace lamina
