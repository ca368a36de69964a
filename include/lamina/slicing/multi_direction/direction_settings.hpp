// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How a part is cut into pieces that are printed flat, each along a direction of its own.
struct DirectionSettings {
  int count = 321;             ///< least number of directions tried, spread evenly over the half sphere
  int beam = 10;               ///< width of the beam search: number of sequences of cuts kept at each step
  int most_cuts = 8;           ///< greatest number of cuts
  double max_tilt_deg = 90.0;  ///< greatest angle of a direction from the vertical
  /// Greatest overhang that the material can bear: angle of a surface from the piece's direction.
  double max_overhang_deg = 45.0;
  double cell_mm = 0.0;  ///< side of the voxels in which cuts are searched; 0 to derive it from the volume
  /// Greatest share of the surface that overhangs by more than that; above it the part is refused.
  double largest_unsupported_percent = 5.0;
};

/// Adds the keys directions.*.
void describe(SettingsSchema& schema, DirectionSettings& settings);

}  // namespace lamina
