// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "infill/variable_width/medial_beads.hpp"
#include "lamina/geometry/medial_axis/medial_axis.hpp"

namespace lamina {

/// The medial axis of a region as far as beads follow it: without what the round end of a bead covers anyway,
/// and without what is thinner than the least width.
MedialAxis beadAxis(const Region& region, const MedialBeadSettings& settings);

/// @throws InvalidInput if the pitch is not positive
void requirePitch(const MedialBeadSettings& settings);

}  // namespace lamina
