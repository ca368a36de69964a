// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "infill/variable_width/medial_beads.hpp"
#include "infill/variable_width/skeleton_paths.hpp"

namespace lamina {

/// The beads along one skeleton path of a medial axis: one or several side by side, which together are as
/// wide as the region at each point.
std::vector<FillPath> skeletonBeads(const SkeletonPath& skeleton_path, const MedialBeadSettings& settings);

}  // namespace lamina
