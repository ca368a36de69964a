// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "arguments/setting_options.hpp"
#include "lamina/job/incline_settings.hpp"

namespace lamina::cli {

/// The command line of `lamina incline` as typed. Empty values were not given.
struct InclineArguments {
  std::string program;
  std::string output;
  SettingOptions settings;
  std::vector<SettingText> options;  ///< options that are settings
  std::string begin_code;            ///< file
  std::string end_code;              ///< file
  bool prints_config = false;
};

void addOptions(CLI::App& subcommand, InclineArguments& arguments);

/// The configuration, overridden by the options and then by `--set`.
/// @throws InvalidConfig if settings do not go together
/// @throws FileError if configuration, begin or end code cannot be read
InclineJob jobFrom(const InclineArguments& arguments);

}  // namespace lamina::cli
