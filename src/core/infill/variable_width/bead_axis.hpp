// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "infill/variable_width/medial_beads.hpp"
#include "lamina/geometry/medial_axis/medial_axis.hpp"

namespace lamina {

/// The medial axis of a region without the parts that beads do not follow: those covered by the round end of
/// a bead anyway, and those where the region is thinner than the least width.
MedialAxis beadAxis(const Region& region, const MedialBeadSettings& settings);

/// Refuses a pitch that is not positive.
/// @throws InvalidInput
void requirePitch(const MedialBeadSettings& settings);

}  // namespace lamina
