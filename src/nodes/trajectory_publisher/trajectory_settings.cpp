// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory_settings.hpp"

#include "lamina/kinematics/machine.hpp"

namespace lamina {

void describe(SettingsSchema& schema, TrajectorySettings& settings) {
  schema.choice("machine.name", settings.machine_name, machineNames(), "Machine whose axes move.");
  schema.choice<TrajectoryMode>(
      "mode", settings.mode, {{"visualise", TrajectoryMode::Visualise}, {"follow", TrajectoryMode::Follow}},
      "Play the toolpath in time, or follow the machine's own reports.");
  schema.number("speed_up", settings.speed_up, {0.0, 1e4, true}, "Factor on the speed of playing.");
  schema.number("rate_hz", settings.rate_hz, {0.0, 1000.0, true}, "Positions a second while playing.");
  schema.number("path_spacing_mm", settings.path_spacing_mm, {0.0, 1e3},
                "Least distance between the poses of nozzle_path.");
  describe(schema, settings.motion);
}

}  // namespace lamina
