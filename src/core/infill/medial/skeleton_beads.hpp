// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "infill/medial/skeleton_paths.hpp"
#include "infill/medial/medial_beads.hpp"

namespace lamina {

/// The beads along one trail of a medial axis: one or more side by side, as thick as the region there.
std::vector<FillPath> trailBeads(const AxisTrail& trail, const MedialBeadSettings& settings);

}  // namespace lamina
