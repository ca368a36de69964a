// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// How layers are bent to follow the upper side of a part.
struct HeightFieldSettings {
  double cell_mm = 0.5;         ///< side of the cells of the `HeightField`
  double max_slope_deg = 20.0;  ///< greatest slope of the layers; steeper surfaces are not followed
  double min_thickness = 0.5;   ///< least thickness of the layers, in layer heights
  double max_thickness = 1.5;   ///< greatest thickness of the layers, in layer heights
  /// Weight of an even bend where no surface is followed, relative to the weight of following the surface.
  double evenness = 0.01;
};

/// Adds the keys heightfield.*.
void describe(SettingsSchema& schema, HeightFieldSettings& settings);

}  // namespace lamina
