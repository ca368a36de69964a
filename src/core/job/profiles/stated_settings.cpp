// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/job/profiles/stated_settings.hpp"

#include <algorithm>
#include <fstream>
#include <optional>
#include <utility>

#include "lamina/base/error.hpp"
#include "lamina/base/input_file.hpp"
#include "lamina/job/program_file.hpp"

namespace lamina {
namespace {

constexpr const char* kBegin = "; lamina_settings begin";
constexpr const char* kEnd = "; lamina_settings end";
constexpr const char* kIs = " = ";

std::string inOneLine(const std::string& text) {
  std::string line;
  for (const char c : text) {
    if (c == '\\')
      line += "\\\\";
    else if (c == '\n')
      line += "\\n";
    else
      line += c;
  }
  return line;
}

bool decidesSize(const PlacedSetting& placed) {
  return placed.setting.key == "compensation.shrink_xy" || placed.setting.key == "compensation.shrink_z";
}

std::string asItWas(const std::string& line) {
  std::string text;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] != '\\' || i + 1 == line.size())
      text += line[i];
    else
      text += line[++i] == 'n' ? '\n' : line[i];
  }
  return text;
}

/// Nothing if the program states no settings.
std::optional<std::vector<PlacedSetting>> settingsIn(const std::string& program_path) {
  requireReadable(program_path);
  std::ifstream program(program_path);
  if (!program) throw FileError("cannot open '" + program_path + "'");
  std::vector<PlacedSetting> stated;
  bool is_inside = false;
  int number = 0;
  for (std::string line; std::getline(program, line);) {
    ++number;
    if (!line.empty() && line.back() == '\r') line.pop_back();
    if (line == kEnd) return stated;
    const std::size_t is = line.find(kIs);
    if (is_inside && is != std::string::npos && is > 2)
      stated.push_back({{line.substr(2, is - 2), asItWas(line.substr(is + 3))}, number});
    is_inside = is_inside || line == kBegin;
  }
  return std::nullopt;
}

}  // namespace

std::string settingComments(const JobSettings& settings) {
  JobSettings stated = settings;
  SettingsSchema schema;
  describe(schema, stated);
  std::string text = std::string(kBegin) + "\n";
  for (const Setting& setting : schema.settings())
    text += "; " + setting.key + kIs + inOneLine(setting.get()) + "\n";
  return text + kEnd + "\n";
}

std::vector<PlacedSetting> statedSettings(const std::string& program_path) {
  if (auto stated = settingsIn(program_path)) return *std::move(stated);
  throw InvalidConfig(program_path + ": states no settings; expected a program that was sliced with " +
                      "program.settings_in_file true");
}

JobSettings withStatedShrinkage(JobSettings settings, const std::string& program_path,
                                const std::vector<SettingText>& typed) {
  if (!isGcodeFile(program_path)) return settings;
  SettingsSchema schema;
  describe(schema, settings);
  for (const PlacedSetting& placed : settingsIn(program_path).value_or(std::vector<PlacedSetting>())) {
    const auto isSame = [&](const SettingText& given) { return given.key == placed.setting.key; };
    if (!decidesSize(placed) || std::any_of(typed.begin(), typed.end(), isSame)) continue;
    try {
      schema.set(placed.setting.key, placed.setting.text);
    } catch (const InvalidConfig& error) {
      throw InvalidConfig(program_path + ", line " + std::to_string(placed.line) + ": " + error.what());
    }
  }
  return settings;
}

}  // namespace lamina
