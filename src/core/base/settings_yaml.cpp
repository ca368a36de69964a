// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>
#include <set>

#include "lamina/base/error.hpp"
#include "lamina/base/settings_yaml.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr int kDeepest = 10;  // an alias may lead back to itself

/// Knows no keys, so that it cannot distinguish settings from another file: none of its messages quotes one
/// (`Quotation`).
class Flattener {
 public:
  explicit Flattener(std::string source_name) : source_name_(std::move(source_name)) {}

  void visit(const std::string& prefix, const YAML::Node& map, int depth) {
    for (const auto& entry : map) {
      const std::string key = prefix + entry.first.as<std::string>();
      if (!seen_.insert(key).second) refuse(entry.first, "a key stands twice");
      take(key, entry.second, entry.first, depth);
    }
  }

  std::vector<PlacedSetting> found() && { return std::move(found_); }

 private:
  /// @param named  where messages point to
  void take(const std::string& key, const YAML::Node& value, const YAML::Node& named, int depth) {
    if (value.IsScalar()) {
      add(key, value.Scalar(), named);
    } else if (value.IsMap() || value.IsSequence()) {
      if (depth == kDeepest) refuse(named, "keys are nested too deep");
      value.IsMap() ? visit(key + ".", value, depth + 1) : takeList(key, value, named, depth + 1);
    } else {
      refuse(named, "a key has no single value");
    }
  }

  void takeList(const std::string& key, const YAML::Node& list, const YAML::Node& named, int depth) {
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < list.size(); ++i) {
      if (list[i].IsScalar()) texts.push_back(list[i].Scalar());
      if (!list[i].IsScalar()) take(key + "." + std::to_string(i), list[i], named, depth);
    }
    if (texts.size() == list.size()) add(key, listed(texts, ","), named);
    if (!texts.empty() && texts.size() < list.size()) refuse(named, "a list holds both values and maps");
  }

  void add(const std::string& key, const std::string& text, const YAML::Node& at) {
    found_.push_back({{key, text}, at.Mark().line + 1});
  }

  [[noreturn]] void refuse(const YAML::Node& node, const std::string& what) const {
    throw InvalidConfig(source_name_ + ":" + std::to_string(node.Mark().line + 1) + ": " + what);
  }

  std::string source_name_;
  std::set<std::string> seen_;
  std::vector<PlacedSetting> found_;
};

/// Messages of the parser quote what they could not read, up to the whole file, which `Quotation` forbids.
std::string withoutQuote(const std::string& message) { return message.substr(0, message.find(": ")); }

std::string group(const std::string& key) { return key.substr(0, key.find('.')); }

}  // namespace

std::vector<SettingText> settingsFromYaml(const std::string& yaml, const std::string& source_name) {
  std::vector<SettingText> settings;
  for (PlacedSetting& placed : placedSettingsFromYaml(yaml, source_name))
    settings.push_back(std::move(placed.setting));
  return settings;
}

std::vector<PlacedSetting> placedSettingsFromYaml(const std::string& yaml, const std::string& source_name) {
  try {
    const YAML::Node document = YAML::Load(yaml);
    if (document.IsNull()) return {};
    if (!document.IsMap()) throw InvalidConfig(source_name + ": not a map of settings");
    Flattener flattener(source_name);
    flattener.visit("", document, 1);
    return std::move(flattener).found();
  } catch (const YAML::Exception& error) {
    throw InvalidConfig(source_name + ":" + std::to_string(error.mark.line + 1) +
                        ": no YAML: " + withoutQuote(error.msg) + "; expected a map of settings");
  }
}

std::string settingsToYaml(const SettingsSchema& schema) {
  std::string yaml;
  std::string current;
  for (const Setting& setting : schema.settings()) {
    const bool is_grouped = setting.key.find('.') != std::string::npos;
    if (is_grouped && group(setting.key) != current) yaml += group(setting.key) + ":\n";
    current = is_grouped ? group(setting.key) : "";
    const std::string indent = is_grouped ? "  " : "";
    YAML::Emitter value;
    const bool is_text = setting.type == "text";
    if (is_text) value << YAML::DoubleQuoted;
    value << setting.get();
    const std::string range =
        setting.bounds.empty() ? (is_text ? "" : " (" + setting.type + ")") : " " + setting.bounds;
    yaml += indent + "# " + setting.meaning + range + "\n";
    yaml += indent + setting.key.substr(is_grouped ? current.size() + 1 : 0) + ": " + value.c_str() + "\n";
  }
  return yaml;
}

std::vector<SettingText> settingTexts(const SettingsSchema& schema) {
  std::vector<SettingText> texts;
  texts.reserve(schema.settings().size());
  for (const Setting& setting : schema.settings()) texts.push_back({setting.key, setting.get()});
  return texts;
}

std::string settingsToYaml(const std::vector<SettingText>& settings) {
  std::vector<std::string> groups;
  std::map<std::string, std::vector<SettingText>> settings_of;
  for (const SettingText& setting : settings) {
    const std::string own = group(setting.key);
    auto& others = settings_of[own];
    if (others.empty()) groups.push_back(own);
    const auto earlier = std::find_if(others.begin(), others.end(),
                                      [&](const SettingText& other) { return other.key == setting.key; });
    earlier == others.end() ? others.push_back(setting) : void(earlier->text = setting.text);
  }
  YAML::Emitter yaml;
  yaml << YAML::BeginMap;
  for (const std::string& name : groups) {
    const auto& own = settings_of[name];
    const bool is_grouped =
        std::none_of(own.begin(), own.end(), [&](const SettingText& setting) { return setting.key == name; });
    if (is_grouped) yaml << YAML::Key << name << YAML::Value << YAML::BeginMap;
    for (const SettingText& setting : own)
      yaml << YAML::Key << setting.key.substr(is_grouped ? name.size() + 1 : 0) << YAML::Value
           << setting.text;
    if (is_grouped) yaml << YAML::EndMap;
  }
  yaml << YAML::EndMap;
  return std::string(yaml.c_str()) + "\n";
}

}  // namespace lamina
