// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <yaml-cpp/yaml.h>

#include <set>

#include "lamina/base/error.hpp"
#include "lamina/base/settings.hpp"

namespace lamina {
namespace {

constexpr int kDeepest = 10;  // an alias may lead back to itself

class Flattener {
 public:
  explicit Flattener(std::string source_name) : source_name_(std::move(source_name)) {}

  void visit(const std::string& prefix, const YAML::Node& map, int depth) {
    for (const auto& entry : map) {
      const std::string key = prefix + entry.first.as<std::string>();
      if (!seen_.insert(key).second) refuse(entry.first, key + " stands twice");
      if (entry.second.IsMap()) {
        if (depth == kDeepest) refuse(entry.first, key + " is nested too deep");
        visit(key + ".", entry.second, depth + 1);
      } else if (entry.second.IsScalar()) {
        found_.push_back({key, entry.second.Scalar()});
      } else {
        refuse(entry.first, key + " has no single value");
      }
    }
  }

  std::vector<SettingText> found() && { return std::move(found_); }

 private:
  [[noreturn]] void refuse(const YAML::Node& node, const std::string& what) const {
    throw InvalidConfig(source_name_ + ":" + std::to_string(node.Mark().line + 1) + ": " + what);
  }

  std::string source_name_;
  std::set<std::string> seen_;
  std::vector<SettingText> found_;
};

std::string group(const std::string& key) { return key.substr(0, key.find('.')); }

}  // namespace

std::vector<SettingText> settingsFromYaml(const std::string& yaml, const std::string& source_name) {
  try {
    const YAML::Node document = YAML::Load(yaml);
    if (document.IsNull()) return {};
    if (!document.IsMap()) throw InvalidConfig(source_name + ": not a map of settings");
    Flattener flattener(source_name);
    flattener.visit("", document, 1);
    return std::move(flattener).found();
  } catch (const YAML::Exception& error) {
    throw InvalidConfig(source_name + ":" + std::to_string(error.mark.line + 1) + ": " + error.msg);
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

}  // namespace lamina
