// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/process_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, ProcessSettings& settings) {
  schema.choice(
      "process.kind", settings.kind,
      {{"extruder", ProcessKind::Extruder}, {"powder", ProcessKind::Powder}, {"wire", ProcessKind::Wire}},
      "What deposits: an extruder, or a laser or arc fed by powder or by wire.");
  const Bounds lead{-10.0, 10.0};
  schema.number("process.laser_on_lead_s", settings.laser_on_lead_s, lead,
                "How long before a bead the laser is switched on; negative for after its start.");
  schema.number("process.laser_off_lead_s", settings.laser_off_lead_s, lead,
                "How long before the end of a bead the laser is switched off; negative for after it.");
  schema.number("process.wire_on_lead_s", settings.wire_on_lead_s, lead,
                "How long before a bead the wire is fed; negative for after its start.");
  schema.number("process.wire_off_lead_s", settings.wire_off_lead_s, lead,
                "How long before the end of a bead the wire stops; negative for after it.");
  const Bounds wait{0.0, 600.0};
  schema.number("process.settling_s", settings.settling_s, wait,
                "How long powder and gas run before the first motion, and after a pause.");
  schema.number("process.wait_before_s", settings.wait_before_s, wait, "Rest before each bead.");
  schema.number("process.wait_after_s", settings.wait_after_s, wait, "Rest after each bead.");
}

}  // namespace lamina
