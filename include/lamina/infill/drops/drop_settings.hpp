// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// What the strategies of drops ask for.
struct DropSettings {
  double diameter_mm = 0.4;
  double pitch_mm = 0.4;         ///< between neighbouring drops of a line
  double line_spacing_mm = 0.0;  ///< between neighbouring lines and contours; 0 takes the pitch
  int contours = 1;              ///< round a raster or dense fill
  double most_overlap = 0.2;  ///< of two drops of a layer, 1 - distance / diameter; none is deposited nearer
};

/// Between neighbouring lines and contours [mm].
double lineSpacing(const DropSettings& settings);

/// Adds the keys drops.*.
void describe(SettingsSchema& schema, DropSettings& settings);

}  // namespace lamina
