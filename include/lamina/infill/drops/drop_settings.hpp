// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// Settings of the strategies that deposit drops.
struct DropSettings {
  double diameter_mm = 0.4;
  double pitch_mm = 0.4;         ///< distance of neighbouring drops of a line
  double line_spacing_mm = 0.0;  ///< distance of neighbouring lines and contours; 0 for the pitch
  int contours = 1;              ///< number of contours around a raster or dense fill
  /// Greatest overlap of two drops of a layer, 1 - distance / diameter; drops that are closer are left out.
  double most_overlap = 0.2;
};

/// Distance of neighbouring lines and contours [mm].
double lineSpacing(const DropSettings& settings);

/// Adds the keys drops.*.
void describe(SettingsSchema& schema, DropSettings& settings);

}  // namespace lamina
