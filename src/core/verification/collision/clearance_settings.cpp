// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/collision/clearance_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, ClearanceSettings& settings) {
  schema.choice<ClearanceNeed>("clearance.need", settings.need,
                               {{"turning", ClearanceNeed::Turning},
                                {"always", ClearanceNeed::Always},
                                {"never", ClearanceNeed::Never}},
                               "Which programs are refused if the machine runs into bed, part or itself: of "
                               "joints that turn and of layers that are not plane, all, or none.");
  schema.flag("clearance.raise_tool_axis", settings.raises_tool_axis,
              "Whether the tool axis leans less than the layers ask where the machine would run into "
              "something; by orientation.max_off_normal_deg at most.");
  schema.flag("clearance.report", settings.is_shown,
              "Whether the slicing node checks the head for collisions and shows them.");
  schema.number("clearance.spacing_mm", settings.spacing_mm, {0.01, 100.0},
                "Greatest distance between the places of the nozzle that are checked for collisions.");
  schema.number("clearance.tolerance_mm", settings.tolerance_mm, {0.0, 10.0},
                "How deep the head may be in bed or material before it collides.");
}

}  // namespace lamina
