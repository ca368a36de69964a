// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"

namespace lamina {

/// A setting and the line of its file.
struct PlacedSetting {
  SettingText setting;
  int line = 0;  ///< from 1
};

/// As `settingsFromYaml`, with the line of each.
/// @throws InvalidConfig as `settingsFromYaml`
std::vector<PlacedSetting> placedSettingsFromYaml(const std::string& yaml, const std::string& source_name);

/// Key and value of each setting of a schema, in its order.
std::vector<SettingText> settingTexts(const SettingsSchema& schema);

/// Settings as a YAML document that `settingsFromYaml` reads back, grouped by the first part of the key. Of
/// settings with one key, the last counts, in the place of the first.
std::string settingsToYaml(const std::vector<SettingText>& settings);

}  // namespace lamina
