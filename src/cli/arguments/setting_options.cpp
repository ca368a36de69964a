// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "arguments/setting_options.hpp"

namespace lamina::cli {

void addSettingOptions(CLI::App& subcommand, SettingOptions& options, const std::string& meaning) {
  subcommand.add_option("--config", options.config, meaning);
  subcommand
      .add_option("--set", options.assignments,
                  "One setting as key=value; may be repeated, of one key the last counts")
      ->allow_extra_args(false);
}

std::vector<SettingText> overridesFrom(const std::vector<std::string>& assignments) {
  std::vector<SettingText> overrides;
  overrides.reserve(assignments.size());
  for (const std::string& assignment : assignments) overrides.push_back(settingFromAssignment(assignment));
  return overrides;
}

JobSettings jobSettingsFrom(const SettingOptions& options) {
  return loadJobSettings(options.config, overridesFrom(options.assignments));
}

}  // namespace lamina::cli
