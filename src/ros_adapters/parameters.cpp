// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameters.hpp"

#include "lamina/base/error.hpp"
#include "lamina/base/exact_text.hpp"
#include "lamina/base/text.hpp"
#include "names.hpp"

namespace lamina {
namespace {

using XmlRpc::XmlRpcValue;

struct Parameter {
  SettingText setting;
  XmlRpcValue::Type type;
};

std::string textOf(const std::string& key, XmlRpcValue& value) {
  switch (value.getType()) {
    case XmlRpcValue::TypeBoolean:
      return static_cast<bool>(value) ? "true" : "false";
    case XmlRpcValue::TypeInt:
      return std::to_string(static_cast<int>(value));
    case XmlRpcValue::TypeDouble:
      return exactText(static_cast<double>(value));
    case XmlRpcValue::TypeString:
      return static_cast<std::string>(value);
    default:
      throw InvalidConfig("parameter " + key +
                          " is a date or binary; must be a value, a list of values or a list of groups");
  }
}

/// Heard before there were settings, or by diagnostic_updater.
bool isNoSetting(const std::string& key) {
  return key == names::kPluginsParameter || key == names::kDiagnosticPeriodParameter;
}

bool isGroup(const XmlRpcValue& value) {
  return value.getType() == XmlRpcValue::TypeStruct || value.getType() == XmlRpcValue::TypeArray;
}

void flatten(const std::string& prefix, XmlRpcValue& group, std::vector<Parameter>& found);

/// As in files of settings: values with commas between them, or groups whose names are their numbers.
void flattenList(const std::string& key, XmlRpcValue& list, std::vector<Parameter>& found) {
  std::vector<std::string> texts;
  XmlRpcValue groups;
  for (int i = 0; i < list.size(); ++i) {
    if (isGroup(list[i]))
      groups[std::to_string(i)] = list[i];
    else
      texts.push_back(textOf(key, list[i]));
  }
  if (!groups.valid()) return found.push_back({{key, listed(texts, ",")}, XmlRpcValue::TypeArray});
  if (!texts.empty())
    throw InvalidConfig("parameter " + key + " is a list of " + std::to_string(texts.size()) +
                        " values and " + std::to_string(groups.size()) + " groups; must hold one kind");
  flatten(key + ".", groups, found);
}

void flatten(const std::string& prefix, XmlRpcValue& group, std::vector<Parameter>& found) {
  for (auto& [name, value] : group) {
    const std::string key = prefix + name;
    if (isNoSetting(key)) continue;
    if (value.getType() == XmlRpcValue::TypeStruct)
      flatten(key + ".", value, found);
    else if (value.getType() == XmlRpcValue::TypeArray)
      flattenList(key, value, found);
    else
      found.push_back({{key, textOf(key, value)}, value.getType()});
  }
}

std::vector<Parameter> parameters(const ros::NodeHandle& node) {
  XmlRpcValue root;
  std::vector<Parameter> found;
  if (node.getParam(node.getNamespace(), root) && root.getType() == XmlRpcValue::TypeStruct)
    flatten("", root, found);
  return found;
}

bool fits(const std::string& setting_type, XmlRpcValue::Type type) {
  if (setting_type == "flag") return type == XmlRpcValue::TypeBoolean;
  if (setting_type == "integer") return type == XmlRpcValue::TypeInt;
  if (setting_type == "number") return type == XmlRpcValue::TypeInt || type == XmlRpcValue::TypeDouble;
  if (setting_type == "table") return true;
  const bool are_numbers = setting_type.find("numbers") != std::string::npos;
  if (type == XmlRpcValue::TypeArray) return are_numbers || setting_type == "text";
  if (setting_type == "numbers" && type != XmlRpcValue::TypeBoolean) return true;
  return type == XmlRpcValue::TypeString;
}

/// YAML takes more words for truth values than those that a person would.
std::string hintFor(XmlRpcValue::Type type) {
  if (type == XmlRpcValue::TypeArray) return "; it is a list";
  return type == XmlRpcValue::TypeBoolean
             ? "; in YAML the words on, off, yes and no have to stand in quotes to be words"
             : "";
}

std::string onOneLine(const std::string& text) {
  std::string line;
  for (const char c : text) line += c == '\n' ? std::string("\\n") : std::string(1, c);
  return line;
}

}  // namespace

std::vector<SettingText> settingsFromParameters(const ros::NodeHandle& node) {
  std::vector<SettingText> settings;
  for (Parameter& parameter : parameters(node)) settings.push_back(std::move(parameter.setting));
  return settings;
}

void applyParameters(SettingsSchema& schema, const ros::NodeHandle& node) {
  for (const auto& [setting, type] : parameters(node)) {
    const Setting* known = schema.find(setting.key);
    if (known != nullptr && !fits(known->type, type))
      throw InvalidConfig(setting.key + " is '" + setting.text + "', which is no " + known->type +
                          hintFor(type));
    schema.set(setting.key, setting.text);
  }
}

std::string describeSettings(const SettingsSchema& schema) {
  std::string lines;
  for (const Setting& setting : schema.settings())
    lines += "\n  " + setting.key + ": " + onOneLine(setting.get());
  return lines;
}

}  // namespace lamina
