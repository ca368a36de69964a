// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "lamina/base/progress.hpp"
#include "lamina/job/job_settings.hpp"
#include "lamina/job/kinematic_model_run.hpp"
#include "setting_options.hpp"

namespace lamina::cli {

/// The input to be run, and the machine, as typed.
struct MachineRunArguments {
  std::string input;
  std::string machine;  ///< name, profile or file; empty for that of the settings
};

/// Adds the input and --machine.
void addMachineRun(CLI::App& subcommand, MachineRunArguments& arguments);

/// The settings with the machine.
/// @throws InvalidConfig as `validate`; if a program in a robot's language is to run on the default gantry
JobSettings settingsOnMachine(const SettingOptions& options, const MachineRunArguments& run);

/// The joint values of a program; for an input without joint values, those by which the machine would run it.
/// @throws as the readers of its kind, and `runOn`
KinematicModelRun runOfInput(const CheckedMachine& machine, const std::string& input,
                             const JobSettings& settings, Progress& progress);

}  // namespace lamina::cli
