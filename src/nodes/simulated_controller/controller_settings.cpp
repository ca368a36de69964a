// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "controller_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, ControllerSettings& settings) {
  describe(schema, settings.machine, "Machine or robot that is simulated.");
  describe(schema, settings.servo);
  describeFeeder(schema, settings.plant);
  schema.number("report_hz", settings.report_hz, {0.0, 1000.0, true},
                "Positions, feedback and process states a second.");
  schema.number("path_tolerance", settings.path_tolerance, {0.0, 1e3},
                "Error of a joint, in mm or rad, that aborts the goal; 0 for none.");
  schema.number(
      "host_wait_s", settings.host_wait_s, {0.0, 3600.0},
      "How late points, their process and goals from rest may come: simulated time stands still for them.");
}

}  // namespace lamina
