// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "lamina/servo/servoj_drive.hpp"

namespace lamina {

struct ServoBridgeSettings {
  MachineSettings machine = {"irb_4600", ""};
  ServojDriveSettings drive;
  bool is_emulated = false;     ///< whether the robot is emulated
  double report_hz = 50.0;      ///< of positions and feedback
  double path_tolerance = 0.0;  ///< of every joint while it follows [rad]; 0 for none
};

/// Adds the keys machine.*, servoj.*, cyclic.*, robot.*, emulated, report_hz and path_tolerance.
void describe(SettingsSchema& schema, ServoBridgeSettings& settings);

}  // namespace lamina
