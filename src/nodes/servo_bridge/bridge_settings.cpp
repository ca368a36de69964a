// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "bridge_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, ServoBridgeSettings& settings) {
  describe(schema, settings.machine, "Robot that is led, of six rotary joints.");
  describe(schema, settings.drive);
  schema.flag("emulated", settings.is_emulated,
              "Whether a robot that is not there is led, within the node, in the place of robot.host.");
  schema.number("report_hz", settings.report_hz, Bounds::above(0.0, 1000.0),
                "Positions and feedback a second.");
  schema.number("path_tolerance", settings.path_tolerance, {0.0, 1e3},
                "Error of a joint, in rad, that aborts the goal; 0 for none.");
}

}  // namespace lamina
