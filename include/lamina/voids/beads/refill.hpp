// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/infill/fill_path.hpp"
#include "lamina/voids/beads/void_map.hpp"

namespace lamina {

/// Which voids are filled (`refill`).
struct RefillSettings {
  double least_area = 0.25;   ///< least area of a void that is filled, in squared pitches
  double least_width = 0.25;  ///< width of a void below which no bead is deposited, in pitches
};

/// Paths of role GapFill that fill the voids of a layer: along their medial axes, with beads as wide as the
/// voids; in a void with room for several beads side by side, loops parallel to its border. A void that is
/// too small, or nowhere wide enough, is not filled. Empty if the layer deposits nothing.
/// @throws InvalidInput if a setting is negative
std::vector<FillPath> refill(const LayerVoids& layer, const RefillSettings& settings);

}  // namespace lamina
