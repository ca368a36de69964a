// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/base/progress.hpp"
#include "lamina/job/job_settings.hpp"
#include "lamina/job/kinematic_model_run.hpp"
#include "setting_options.hpp"

namespace lamina::cli {

/// The settings with a machine by its name, profile or file.
/// @param machine  empty for that of the settings
JobSettings settingsOnMachine(const SettingOptions& options, const std::string& machine);

/// The joints that a program holds; of what holds none, those by which the machine would run it.
/// @throws as the readers of its kind, and `runOn`
KinematicModelRun runOfInput(const KinematicModel& model, const std::string& input,
                             const JobSettings& settings, Progress& progress);

}  // namespace lamina::cli
