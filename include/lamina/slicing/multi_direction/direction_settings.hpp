// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How a part is cut into pieces that are printed flat, each along a direction of its own.
struct DirectionSettings {
  int count = 321;                 ///< directions tried, at least: evenly over the half sphere
  int beam = 10;                   ///< sequences of cuts that are followed side by side
  int most_cuts = 8;               ///< of a sequence
  double max_tilt_deg = 90.0;      ///< of a direction from up
  double max_overhang_deg = 45.0;  ///< that the material takes, from a piece's direction
  double cell_mm = 0.0;            ///< side of the cells that pieces are weighed in; 0 for one by the part
  double largest_unsupported_percent = 5.0;  ///< of the surface, before the part is refused
};

/// Adds the keys directions.*.
void describe(SettingsSchema& schema, DirectionSettings& settings);

}  // namespace lamina
