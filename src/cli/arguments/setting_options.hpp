// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/job/job_settings.hpp"

namespace lamina::cli {

/// `--config` and `--set` as they were typed.
struct SettingOptions {
  std::string config;                    ///< file; empty for none
  std::vector<std::string> assignments;  ///< key=value
};

/// Adds both options.
/// @param meaning  of the file
void addSettingOptions(CLI::App& subcommand, SettingOptions& options, const std::string& meaning);

/// What was set one by one, in order.
/// @throws InvalidConfig if one is no key=value
std::vector<SettingText> overridesFrom(const std::vector<std::string>& assignments);

/// The settings of a job: the defaults, overridden by the file and then one by one.
/// @throws InvalidConfig, FileError as `loadJobSettings`
JobSettings jobSettingsFrom(const SettingOptions& options);

}  // namespace lamina::cli
