// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/infill/drops/drop_settings.hpp"

namespace lamina {

double lineSpacing(const DropSettings& settings) {
  return settings.line_spacing_mm > 0.0 ? settings.line_spacing_mm : settings.pitch_mm;
}

void describe(SettingsSchema& schema, DropSettings& settings) {
  schema.number("drops.diameter_mm", settings.diameter_mm, {0.001, 100.0}, "Diameter of a drop.");
  schema.number("drops.pitch_mm", settings.pitch_mm, {0.001, 100.0},
                "Distance of neighbouring drops of a line.");
  schema.number("drops.line_spacing_mm", settings.line_spacing_mm, {0.0, 100.0},
                "Distance of neighbouring lines and contours of drops; 0 takes the pitch.");
  schema.integer("drops.contours", settings.contours, {1, 100},
                 "Number of contours round a raster or dense fill of drops.");
  schema.number("drops.most_overlap", settings.most_overlap, {0.0, 0.9},
                "Most that two drops of a fill overlap, as part of the diameter; drops nearer are left out.");
}

}  // namespace lamina
