// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/base/settings_schema.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

#include "lamina/base/atomic_file.hpp"
#include "lamina/base/edit_distance.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/exact_text.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

/// With a dot before an exponent: YAML 1.1, which rosparam reads, takes 1e-06 for text.
std::string withDot(std::string number) {
  const std::size_t exponent = number.find('e');
  if (exponent != std::string::npos && number.find('.') == std::string::npos) number.insert(exponent, ".0");
  return number;
}

std::string describeBounds(const Bounds& bounds) {
  const std::string high = std::isinf(bounds.high) ? "inf)" : exactText(bounds.high) + "]";
  const std::string low =
      std::isinf(bounds.low) ? "(-inf" : (bounds.excludes_low ? "(" : "[") + exactText(bounds.low);
  return low + ", " + high;
}

[[noreturn]] void refuse(const std::string& key, const std::string& text, const std::string& expected) {
  throw InvalidConfig(key + " is '" + text + "'; must be " + expected);
}

template <class Number>
Number parse(const std::string& key, const std::string& text, const std::string& expected) {
  Number value{};
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  if (result.ec != std::errc{} || result.ptr != end) refuse(key, text, expected);
  return value;
}

bool isInside(double value, const Bounds& bounds) {
  if (!std::isfinite(value)) return false;
  return value <= bounds.high && (bounds.excludes_low ? value > bounds.low : value >= bounds.low);
}

/// Numbers with commas between them; none in an empty text.
std::vector<double> parseList(const std::string& key, const std::string& text, const std::string& expected) {
  std::vector<double> values;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t comma = std::min(text.find(',', begin), text.size());
    double value = 0.0;
    const auto result = std::from_chars(text.data() + begin, text.data() + comma, value);
    if (result.ec != std::errc{} || result.ptr != text.data() + comma || !std::isfinite(value))
      refuse(key, text, expected);
    values.push_back(value);
    if (comma + 1 == text.size()) refuse(key, text, expected);
    begin = comma + 1;
  }
  return values;
}

std::string listText(const std::vector<double>& numbers) {
  std::vector<std::string> texts;
  texts.reserve(numbers.size());
  for (const double value : numbers) texts.push_back(exactText(value));
  return listed(texts, ",");
}

/// As YAML reads it between double quotes.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    c == '\n' ? result += "\\n" : result += c;
  }
  return result + '"';
}

std::string tableText(const SettingTable& table) {
  std::vector<std::string> entries;
  entries.reserve(table.size());
  for (const auto& [name, text] : table) entries.push_back(quoted(name) + ": " + quoted(text));
  return entries.empty() ? "" : "{" + listed(entries) + "}";
}

/// @param text  a map or list in one line, or a map of several
SettingTable parseTable(const std::string& key, const std::string& text) {
  const std::size_t first = text.find_first_not_of(' ');
  const bool is_flow = first != std::string::npos && (text[first] == '{' || text[first] == '[');
  const std::string prefix = is_flow ? "entries." : "";
  SettingTable table;
  for (SettingText& entry : settingsFromYaml(is_flow ? "entries: " + text : text, key))
    table.emplace(entry.key.substr(std::min(prefix.size(), entry.key.size())), std::move(entry.text));
  return table;
}

/// "; did you mean ...?" with the key that is nearest; empty if there are none.
std::string keySuggestion(const SettingsSchema& schema, const std::string& key) {
  std::vector<std::string> keys;
  for (const Setting& setting : schema.settings()) keys.push_back(setting.key);
  return suggestionFor(keys, key);
}

}  // namespace

void SettingsSchema::number(const std::string& key, double& field, Bounds bounds,
                            const std::string& meaning) {
  const std::string expected = "a number in " + describeBounds(bounds);
  const auto set = [key, &field, bounds, expected](const std::string& text) {
    const double value = parse<double>(key, text, expected);
    if (!isInside(value, bounds)) refuse(key, text, expected);
    field = value;
  };
  settings_.push_back(
      {key, "number", describeBounds(bounds), meaning, set, [&field] { return withDot(exactText(field)); }});
}

void SettingsSchema::integer(const std::string& key, int& field, Bounds bounds, const std::string& meaning) {
  const std::string expected = "an integer in " + describeBounds(bounds);
  const auto set = [key, &field, bounds, expected](const std::string& text) {
    const int value = parse<int>(key, text, expected);
    if (!isInside(value, bounds)) refuse(key, text, expected);
    field = value;
  };
  settings_.push_back(
      {key, "integer", describeBounds(bounds), meaning, set, [&field] { return std::to_string(field); }});
}

void SettingsSchema::flag(const std::string& key, bool& field, const std::string& meaning) {
  const auto set = [key, &field](const std::string& text) {
    if (text != "true" && text != "false") refuse(key, text, "true or false");
    field = text == "true";
  };
  settings_.push_back(
      {key, "flag", "", meaning, set, [&field] { return std::string(field ? "true" : "false"); }});
}

void SettingsSchema::text(const std::string& key, std::string& field, const std::string& meaning) {
  settings_.push_back({key, "text", "", meaning, [&field](const std::string& text) { field = text; },
                       [&field] { return field; }});
}

void SettingsSchema::numbers(const std::string& key, std::vector<double>& field, std::size_t count,
                             const std::string& meaning) {
  const std::string type = std::to_string(count) + " numbers";
  const std::string expected = type + " with commas between them, or empty";
  const auto set = [key, &field, count, expected](const std::string& text) {
    std::vector<double> values = parseList(key, text, expected);
    if (!values.empty() && values.size() != count) refuse(key, text, expected);
    field = std::move(values);
  };
  settings_.push_back({key, type, "", meaning, set, [&field] { return listText(field); }});
}

void SettingsSchema::list(const std::string& key, std::vector<double>& field, Bounds bounds,
                          const std::string& meaning) {
  const std::string expected = "numbers in " + describeBounds(bounds) + " with commas between them, or empty";
  const auto set = [key, &field, bounds, expected](const std::string& text) {
    std::vector<double> values = parseList(key, text, expected);
    for (const double value : values)
      if (!isInside(value, bounds)) refuse(key, text, expected);
    field = std::move(values);
  };
  settings_.push_back(
      {key, "numbers", describeBounds(bounds), meaning, set, [&field] { return listText(field); }});
}

void SettingsSchema::table(const std::string& key, SettingTable& field, const std::string& meaning) {
  Setting setting;
  setting.key = key;
  setting.type = "table";
  setting.meaning = meaning;
  setting.set = [key, &field](const std::string& text) { field = parseTable(key, text); };
  setting.get = [&field] { return tableText(field); };
  setting.set_entry = [&field](const std::string& entry, const std::string& text) { field[entry] = text; };
  settings_.push_back(std::move(setting));
}

void SettingsSchema::choice(const std::string& key, std::string& field,
                            const std::vector<std::string>& choices, const std::string& meaning) {
  addChoice(
      key, choices, meaning, [&field, choices](std::size_t i) { field = choices[i]; },
      [&field] { return field; });
}

void SettingsSchema::addChoice(const std::string& key, const std::vector<std::string>& names,
                               const std::string& meaning, const std::function<void(std::size_t)>& choose,
                               std::function<std::string()> get) {
  const std::string list = listed(names, " | ");
  const auto set = [key, names, list, choose](const std::string& text) {
    const auto found = std::find(names.begin(), names.end(), text);
    if (found == names.end()) refuse(key, text, "one of " + list);
    choose(static_cast<std::size_t>(found - names.begin()));
  };
  settings_.push_back({key, list, "", meaning, set, std::move(get)});
}

void SettingsSchema::validate() const {
  // Values travel as text, exactly; setting each to what it is goes through the same checks as setting it at
  // all.
  for (const Setting& setting : settings_) setting.set(setting.get());
}

void SettingsSchema::renamed(const std::string& former_key, const std::string& key) {
  former_keys_.emplace_back(former_key, key);
}

void SettingsSchema::renamedChoice(const std::string& key, const std::string& former_name,
                                   const std::string& name) {
  for (Setting& setting : settings_)
    if (setting.key == key)
      setting.set = [set = setting.set, former_name, name](const std::string& text) {
        set(text == former_name ? name : text);
      };
}

const Setting* SettingsSchema::find(const std::string& key) const {
  std::string present = key;
  for (const auto& [former, now] : former_keys_)
    if (former == key) present = now;
  for (const Setting& setting : settings_)
    if (setting.key == present) return &setting;
  for (const Setting& setting : settings_)
    if (setting.set_entry && present.compare(0, setting.key.size() + 1, setting.key + ".") == 0)
      return &setting;
  return nullptr;
}

void SettingsSchema::set(const std::string& key, const std::string& text) {
  const Setting* const setting = find(key);
  const bool is_entry = setting != nullptr && setting->set_entry &&
                        key.compare(0, setting->key.size() + 1, setting->key + ".") == 0;
  if (is_entry) return setting->set_entry(key.substr(setting->key.size() + 1), text);
  if (setting != nullptr) return setting->set(text);
  throw InvalidConfig("unknown setting '" + key + "'" + keySuggestion(*this, key));
}

namespace {

/// A file of which no key is known may be no settings at all: then its keys are not shown.
void applyFile(SettingsSchema& schema, const std::string& path) {
  const std::vector<SettingText> settings = settingsFromYaml(readFile(path), path);
  const bool is_known = std::any_of(settings.begin(), settings.end(), [&](const SettingText& setting) {
    return schema.find(setting.key) != nullptr;
  });
  if (!settings.empty() && !is_known)
    throw InvalidConfig(path + ": none of its keys is a setting" +
                        keySuggestion(schema, settings.front().key));
  for (const SettingText& setting : settings) schema.set(setting.key, setting.text);
}

}  // namespace

void applySettings(SettingsSchema& schema, const std::string& yaml_path,
                   const std::vector<SettingText>& overrides) {
  if (!yaml_path.empty()) applyFile(schema, yaml_path);
  for (const SettingText& setting : overrides) schema.set(setting.key, setting.text);
}

SettingText settingFromAssignment(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InvalidConfig("'" + assignment + "' is no setting; expected key=value");
  return {assignment.substr(0, equals), assignment.substr(equals + 1)};
}

}  // namespace lamina
