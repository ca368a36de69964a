// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "infill/variable_width/medial_beads.hpp"

namespace lamina {

/// Runs of role GapFill that fill regions of any thickness. Narrow regions are filled by beads along their
/// medial axes. Regions with room for more than two of the widest beads side by side are filled by loops
/// parallel to the border, a pitch wide, and by beads along the medial axes of what the loops leave over. No
/// bead is wider than the widest.
/// @param least_rest  in squared pitches: smaller areas left over between loops stay open
/// @throws InvalidInput if the pitch is not positive, or too small for the region (`requireContourSpacing`)
std::vector<FillPath> solidBeads(const Regions& regions, const MedialBeadSettings& settings,
                                 double least_rest);

}  // namespace lamina
