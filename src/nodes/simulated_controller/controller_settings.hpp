// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings.hpp"
#include "lamina/deposition/growth_plant.hpp"
#include "lamina/kinematics/cartesian/machine_settings.hpp"
#include "lamina/trajectory/simulated_controller.hpp"

namespace lamina {

struct ControllerSettings {
  MachineSettings machine;
  ServoSettings servo;
  PlantSettings plant;          ///< of which the feeder counts
  double report_hz = 50.0;      ///< of positions, feedback and the process
  double path_tolerance = 0.0;  ///< of every joint while it follows [mm, rad]; 0 for none
  double host_wait_s = 0.0;     ///< that a slow host may be late with goals and their process
};

/// Adds the keys machine.*, servo.*, those of plant.* that are of the feeder, report_hz, path_tolerance and
/// host_wait_s.
void describe(SettingsSchema& schema, ControllerSettings& settings);

}  // namespace lamina
