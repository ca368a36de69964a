// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/settings_schema.hpp"
#include "lamina/deposition/deposition_settings.hpp"
#include "lamina/deposition/path_follower.hpp"
#include "lamina/kinematics/machine_choice.hpp"
#include "lamina/program/program_settings.hpp"

namespace lamina {

/// How toolpaths are read and deposited.
struct SimulationSettings {
  DepositionSettings deposition;
  ProgramSettings reading;  ///< filament, flow, words of drops and of five axes by which programs are read
  MachineSettings machine;  ///< that five-axis programs were written for
};

/// Adds the keys deposition.*, program.filament_diameter_mm, program.flow, drop_program.*, five_axis.* and
/// machine.*.
void describe(SettingsSchema& schema, SimulationSettings& settings);

/// Limits of a published deposit; larger deposits are published with coarser voxels.
struct ShownSettings {
  int points = 1000000;
  int triangles = 100000;
};

/// What is deposited besides the toolpaths of goals.
enum class SimulatorMode {
  Simulate,  ///< nothing
  Follow,    ///< the latched toolpath, behind the machine that runs it
};

struct DepositionSimulatorSettings {
  SimulatorMode mode = SimulatorMode::Simulate;
  SimulationSettings simulation;
  FollowingSettings following;
  double period_s = 1.0;  ///< between publications of what is followed
  ShownSettings shown;
};

/// Adds the keys mode, those of `SimulationSettings`, following.* and shown.*.
void describe(SettingsSchema& schema, DepositionSimulatorSettings& settings);

}  // namespace lamina
