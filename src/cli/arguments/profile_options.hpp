// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "arguments/setting_options.hpp"
#include "lamina/job/profiles/layered_settings.hpp"

namespace lamina::cli {

/// `--machine`, `--material`, `--process` and `--like` as they were typed.
struct ProfileOptions {
  std::string machine;
  std::string material;
  std::string process;
  std::string like;
};

/// Adds `--machine`.
void addMachineOption(CLI::App& subcommand, ProfileOptions& options);

/// Adds all of them.
void addProfileOptions(CLI::App& subcommand, ProfileOptions& options);

/// The settings of a job, one source after the other.
/// @throws InvalidConfig, FileError as `loadLayered`
LayeredSettings layeredSettingsFrom(const ProfileOptions& profiles, const SettingOptions& options);

}  // namespace lamina::cli
