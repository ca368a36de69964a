// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "infill/variable_width/medial_beads.hpp"

namespace lamina {

/// Runs of role GapFill that fill regions of any thickness: narrow ones by beads along their medial axes, and
/// those that have room for more than two of the widest beads side by side by loops parallel to the border, a
/// pitch wide, with such beads in what the loops leave. No bead is wider than the widest.
/// @param least_rest  in squared pitches: smaller rests between loops are left open
/// @throws InvalidInput if the pitch is not positive, or too small for the region (`requireContourSpacing`)
std::vector<FillPath> solidBeads(const Regions& regions, const MedialBeadSettings& settings,
                                 double least_rest);

}  // namespace lamina
