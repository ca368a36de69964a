// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How layers are bent to follow the upper side of a part.
struct HeightFieldSettings {
  double cell_mm = 0.5;         ///< of the grid that holds the bend
  double max_slope_deg = 20.0;  ///< of the layers; steeper surface is not followed
  double min_thickness = 0.5;   ///< of the layers, in layer heights
  double max_thickness = 1.5;
  double evenness = 0.01;  ///< weight of an even bend where no surface is followed, against following
};

/// Adds the keys heightfield.*.
void describe(SettingsSchema& schema, HeightFieldSettings& settings);

}  // namespace lamina
