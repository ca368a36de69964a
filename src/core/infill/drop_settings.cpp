// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/infill/drop_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, DropSettings& settings) {
  schema.number("drops.diameter_mm", settings.diameter_mm, {0.001, 100.0, false}, "Diameter of a drop.");
  schema.number("drops.pitch_mm", settings.pitch_mm, {0.001, 100.0, false},
                "Distance of neighbouring drops of a line.");
}

}  // namespace lamina
