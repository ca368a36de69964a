// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_yaml.hpp"
#include "lamina/job/job_settings.hpp"

namespace lamina {

/// All settings of a job as comments of a program, `; key = value`, between two marker lines. Line feeds and
/// backslashes in values are written as `\n` and `\\`.
std::string settingComments(const JobSettings& settings);

/// The settings that the comments of a program state, with their line numbers.
/// @throws FileError; InvalidConfig if it states none
std::vector<PlacedSetting> statedSettings(const std::string& program_path);

/// The settings with the shrinkage (`compensation.shrink_xy`, `compensation.shrink_z`) that the program
/// states its part was enlarged for, but for keys in `typed`; as they are if it states none, or is no G-code.
/// @param typed  settings that a person has given, which hold
/// @throws FileError; InvalidConfig naming file and line if a stated value is none
JobSettings withStatedShrinkage(JobSettings settings, const std::string& program_path,
                                const std::vector<SettingText>& typed);

}  // namespace lamina
