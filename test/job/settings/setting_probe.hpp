// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/job/job_settings.hpp"

namespace lamina::test {

using SettingTexts = std::vector<SettingText>;

/// One setting that is changed, and what has to be set besides for it to matter, as "key=value;key=value".
/// Where a value asks for another setting's, that one stands behind it in the change.
struct SettingRow {
  const char* change;
  const char* with = "";
};

/// What depends on settings: each of the rows must change the result.
struct SettingProbe {
  std::string name;
  std::string base;                                            ///< as `SettingRow::with`, of all rows
  std::function<std::string(const SettingTexts& set)> result;  ///< the same text for the same settings
  std::vector<SettingRow> rows;
};

/// Key of the setting that a row is about.
std::string changedKey(const SettingRow& row);

/// "key=value;key=value" as settings.
SettingTexts settingTexts(const std::string& assignments);

/// Struct of settings that has some of them set.
template <class Settings>
Settings settingsWith(const SettingTexts& set) {
  Settings settings;
  SettingsSchema schema;
  describe(schema, settings);
  for (const SettingText& setting : set) schema.set(setting.key, setting.text);
  return settings;
}

/// From walls and infill alone on (`plainSettings`): a setting has its effect whatever jobs do by default.
template <>
JobSettings settingsWith<JobSettings>(const SettingTexts& set);

template <class Settings>
std::vector<std::string> keysOf() {
  Settings settings;
  SettingsSchema schema;
  describe(schema, settings);
  std::vector<std::string> keys;
  for (const Setting& setting : schema.settings()) keys.push_back(setting.key);
  return keys;
}

/// Numbers, each with 12 digits, on one line.
std::string numbersText(const std::vector<double>& numbers);

/// What a probe makes of a row, or what it refuses it with. Contradictory settings are no result: they throw.
std::string resultOf(const SettingProbe& probe, const std::string& with, const std::string& change);
bool isRefusal(const std::string& result);

/// Path of the STL file of a part, as "box x_mm=8 y_mm=6"; written once.
std::string partFile(const std::string& part);

/// Expects that every row of the probes has its effect; prints it where LAMINA_SHOW_EFFECTS is set.
void expectEffects(const std::vector<SettingProbe>& probes);

// By what they are about.
std::vector<SettingProbe> sliceProbes();
std::vector<SettingProbe> supportProbes();
std::vector<SettingProbe> layerProbes();
std::vector<SettingProbe> fillProbes();
std::vector<SettingProbe> flowProbes();
std::vector<SettingProbe> runProbes();
std::vector<SettingProbe> dropProbes();
std::vector<SettingProbe> profileProbes();
std::vector<SettingProbe> programProbes();
std::vector<SettingProbe> jointProbes();
std::vector<SettingProbe> motionProbes();
std::vector<SettingProbe> measureProbes();
std::vector<SettingProbe> platformProbes();
std::vector<SettingProbe> inclineProbes();
std::vector<SettingProbe> searchProbes();
std::vector<SettingProbe> scaffoldProbes();
std::vector<SettingProbe> streamProbes();
std::vector<SettingProbe> emulatorProbes();
std::vector<SettingProbe> startupProbes();
std::vector<SettingProbe> approachProbes();
std::vector<SettingProbe> monitorProbes();
std::vector<SettingProbe> bridgeProbes();
std::vector<SettingProbe> skinProbes();
std::vector<SettingProbe> heightProbes();
std::vector<SettingProbe> arcProbes();
std::vector<SettingProbe> hookProbes();
std::vector<SettingProbe> plateProbes();
std::vector<SettingProbe> toolProbes();
std::vector<SettingProbe> loopProbes();
std::vector<SettingProbe> resumeProbes();
std::vector<SettingProbe> calibrationProbes();

}  // namespace lamina::test
