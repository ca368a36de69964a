// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/deposition/grown_deposit.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "lamina/monitoring/profile_sensor.hpp"
#include "lamina/trajectory/simulated_controller.hpp"

namespace lamina {

struct ControllerSettings {
  MachineSettings machine;
  ServoSettings servo;
  PlantSettings plant;          ///< deviations of the process
  double report_hz = 50.0;      ///< of positions, feedback and the process
  double path_tolerance = 0.0;  ///< of every joint while it follows [mm, rad]; 0 for none
  double host_wait_s = 0.0;     ///< time by which a slow host may be late with goals and their process
  std::vector<double> deposit_area_mm;  ///< area of the bed with deposits: least x, y, greatest x, y;
                                        ///< empty keeps and measures nothing
  double deposit_cell_mm = 0.25;        ///< side of a cell of the deposit's map
  GrownDepositSettings grown;
  ProfileSensorSettings sensor;
  std::vector<double> sensor_mount_mm;    ///< sensor in the nozzle's frame, where the URDF has none; empty:
                                          ///< its stand-off above the tip
  bool profile_while_depositing = false;  ///< whether the sensor also measures while something flows
};

/// Adds the keys machine.*, servo.*, plant.*, deposit.*, sensor.*, report_hz, path_tolerance, host_wait_s and
/// profile_while_depositing.
void describe(SettingsSchema& schema, ControllerSettings& settings);

/// Position of the sensor in the nozzle's frame [mm] if the URDF has no sensor; it looks along the nozzle.
Point3 sensorMount(const ControllerSettings& settings);

}  // namespace lamina
