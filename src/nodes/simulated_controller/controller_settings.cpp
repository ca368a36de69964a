// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "controller_settings.hpp"

namespace lamina {

void describe(SettingsSchema& schema, ControllerSettings& settings) {
  describe(schema, settings.machine, "Machine or robot that is simulated.");
  describe(schema, settings.servo);
  describe(schema, settings.plant);
  schema.number("report_hz", settings.report_hz, Bounds::above(0.0, 1000.0),
                "Positions, feedback and process states a second.");
  schema.number("path_tolerance", settings.path_tolerance, {0.0, 1e3},
                "Error of a joint, in mm or rad, that aborts the goal; 0 for none.");
  schema.number(
      "host_wait_s", settings.host_wait_s, {0.0, 3600.0},
      "How late points, their process and goals from rest may come: simulated time stands still for them.");
  schema.numbers(
      "deposit.area_mm", settings.deposit_area_mm, 4,
      "Part of the bed on which what is deposited is kept and measured: least x and y, greatest x and "
      "y; empty for none.");
  schema.number("deposit.cell_mm", settings.deposit_cell_mm, {0.02, 10.0},
                "Cell of the map of what is deposited.");
  describe(schema, settings.grown);
  describe(schema, settings.sensor);
  schema.numbers("sensor.mount_mm", settings.sensor_mount_mm, 3,
                 "Sensor in the frame of the nozzle, looking along its axis, where the URDF has no link "
                 "sensor; empty for its stand-off above the tip.");
  schema.flag("profile_while_depositing", settings.profile_while_depositing,
              "Whether the sensor also measures while something flows.");
}

Point3 sensorMount(const ControllerSettings& settings) {
  const std::vector<double>& mount = settings.sensor_mount_mm;
  if (mount.empty()) return {0.0, 0.0, -settings.sensor.stand_off_mm};
  return {mount[0], mount[1], mount[2]};
}

}  // namespace lamina
