// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/collision/clearance_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, ClearanceSettings& settings) {
  schema.flag("clearance.report", settings.is_shown,
              "Whether the slicing node checks the head for collisions and shows them.");
  schema.number("clearance.spacing_mm", settings.spacing_mm, {0.01, 100.0},
                "Greatest distance between the places of the nozzle that are checked for collisions.");
  schema.number("clearance.tolerance_mm", settings.tolerance_mm, {0.0, 10.0},
                "How deep the head may be in bed or material before it collides.");
}

}  // namespace lamina
