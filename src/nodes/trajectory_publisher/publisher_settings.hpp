// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/settings_schema.hpp"
#include "lamina/job/run_settings.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "lamina/program/program_settings.hpp"

namespace lamina {

/// Where the axis positions come from.
enum class TrajectoryMode {
  Visualise,  ///< the toolpath, played in time
  Follow,     ///< the machine's own reports
};

struct PublisherSettings {
  MachineSettings machine;
  std::string load_program;  ///< shown and played from the start; empty for none
  ProgramSettings reading;   ///< filament and flow by which programs are read
  TrajectoryMode mode = TrajectoryMode::Visualise;
  double speed_up = 1.0;             ///< of playing
  double rate_hz = 50.0;             ///< of playing
  double cartesian_rate_hz = 100.0;  ///< of cartesian_trajectory
  double path_spacing_mm = 1.0;      ///< least distance between the poses of nozzle_path
  RunSettings run;                   ///< of playing
};

/// Adds the keys machine.*, mode, load_program, program.filament_diameter_mm, program.flow, speed_up,
/// rate_hz, cartesian.rate_hz, path_spacing_mm, joints.*, motion.*, trajectory.* and process.*.
void describe(SettingsSchema& schema, PublisherSettings& settings);

}  // namespace lamina
