// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_yaml.hpp"
#include "lamina/job/job_settings.hpp"

namespace lamina {

/// All settings of a job as comments of a program, `; key = value` between two marks. Line feeds and
/// backslashes in values are written `\n` and `\\`.
std::string settingComments(const JobSettings& settings);

/// The settings that a program states in this way, with their lines.
/// @throws FileError; InvalidConfig if it states none
std::vector<PlacedSetting> statedSettings(const std::string& program_path);

}  // namespace lamina
