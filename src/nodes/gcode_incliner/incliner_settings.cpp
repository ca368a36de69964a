// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "incliner_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, GcodeInclinerSettings& settings) {
  describe(schema, settings.incline);
  schema.number("program.filament_diameter_mm", settings.program.filament_diameter_mm,
                Bounds::above(0.0, 20.0), "Diameter of the filament, for the width of the beads shown.");
  schema.number("program.flow", settings.program.flow, Bounds::above(0.0, 10.0), "Factor on all extrusion.");
  schema.number("view.largest_program_mb", settings.largest_viewed_mb, {0.0, 10000.0},
                "Larger programs are inclined, but not read back and published.");
}

}  // namespace lamina
