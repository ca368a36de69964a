// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// A setting and its line in a file.
struct PlacedSetting {
  SettingText setting;
  int line = 0;  ///< from 1
};

/// Reads a YAML document as `settingsFromYaml` does, with the line of each setting.
/// @throws InvalidConfig as `settingsFromYaml`
std::vector<PlacedSetting> placedSettingsFromYaml(const std::string& yaml, const std::string& source_name);

/// Key and value of each setting of a schema, in the order of the schema.
std::vector<SettingText> settingTexts(const SettingsSchema& schema);

/// Settings as a YAML document that `settingsFromYaml` reads back, grouped by the first part of the key. Of
/// several settings with one key, the last value is written, in the position of the first.
std::string settingsToYaml(const std::vector<SettingText>& settings);

}  // namespace lamina
