// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/infill/fill_path.hpp"
#include "lamina/voids/beads/void_map.hpp"

namespace lamina {

/// Which voids are filled by runs of their own.
struct RefillSettings {
  double least_area = 0.25;   ///< of a void, in squared pitches
  double least_width = 0.25;  ///< in pitches: no bead is deposited where a void is narrower
};

/// Runs of role GapFill along the medial axes of a layer's voids, as wide as the voids are; a void with room
/// for several beads side by side gets loops parallel to its border. A void that is too small, or nowhere
/// wide enough, stays.
/// @throws InvalidInput if a setting is negative
std::vector<FillPath> refill(const LayerVoids& layer, const RefillSettings& settings);

}  // namespace lamina
