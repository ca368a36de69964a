// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/height_field/height_field_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, HeightFieldSettings& settings) {
  schema.number("heightfield.cell_mm", settings.cell_mm, {0.05, 100.0},
                "Cells of the grid by which layers are bent.");
  schema.number("heightfield.max_slope_deg", settings.max_slope_deg, {0.1, 60.0},
                "Steepest slope of a bent layer; steeper surface is not followed.");
  schema.number("heightfield.min_thickness", settings.min_thickness, {0.05, 1.0},
                "Least thickness of a bent layer, in layer heights.");
  schema.number("heightfield.max_thickness", settings.max_thickness, {1.0, 5.0},
                "Greatest thickness of a bent layer, in layer heights.");
  schema.number("heightfield.evenness", settings.evenness, {1e-6, 1.0},
                "Weight of an even bend where no surface is followed, against following.");
}

}  // namespace lamina
