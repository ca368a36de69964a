// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace lamina {

/// Closed interval of values that a numeric setting may take, in the unit of its key: `{low, high}`. An
/// infinite end is open.
struct Bounds {
  double low = 0.0;
  double high = 0.0;
  bool excludes_low = false;  ///< the interval is (low, high]

  /// The interval (low, high].
  static constexpr Bounds above(double low, double high) { return {low, high, true}; }
};

/// A configuration key and the field that it sets. Values are passed as text, in the form that YAML, `--set`
/// and ROS requests have in common.
struct Setting {
  std::string key;  ///< dotted, unit last: "slicing.layer_height_mm"
  /// "number", "integer", "flag", "text", "3 numbers", "numbers", "table", or the choices "a | b | c"
  std::string type;
  std::string bounds;   ///< written as an interval: "(0, 10]"; empty if the type has none
  std::string meaning;  ///< one sentence
  std::function<void(const std::string& text)> set;  ///< throws InvalidConfig naming key, value and bound
  std::function<std::string()> get;                  ///< the field's value as text that `set` accepts
  /// Sets one entry of a table. Empty for every other type.
  std::function<void(const std::string& entry, const std::string& text)> set_entry = {};
};

/// Entries of a YAML map, or of a list of maps, as texts. The name of an entry is its key without that of the
/// table: "12" in a map, "0.nozzle_mm" in a list.
using SettingTable = std::map<std::string, std::string>;

/// The settings of one or more stages. Each stage adds its keys by a function `describe(schema, settings)`.
/// The schema refers to the fields of `settings`, which must outlive it.
class SettingsSchema {
 public:
  void number(const std::string& key, double& field, Bounds bounds, const std::string& meaning);
  void integer(const std::string& key, int& field, Bounds bounds, const std::string& meaning);
  void flag(const std::string& key, bool& field, const std::string& meaning);
  void text(const std::string& key, std::string& field, const std::string& meaning);
  /// A list of exactly `count` finite numbers, separated by commas, or an empty one.
  void numbers(const std::string& key, std::vector<double>& field, std::size_t count,
               const std::string& meaning);
  /// A list of any length, separated by commas, of numbers within the bounds.
  void list(const std::string& key, std::vector<double>& field, Bounds bounds, const std::string& meaning);
  /// A table of entries with any names. `key.name` sets one of them; `key` sets the table, from a YAML map or
  /// list in one line ("{12: M117 nuts}").
  void table(const std::string& key, SettingTable& field, const std::string& meaning);
  /// A text that must be one of `choices`.
  void choice(const std::string& key, std::string& field, const std::vector<std::string>& choices,
              const std::string& meaning);
  /// A value of an enumeration; its text is the name in `choices`.
  template <class Enum>
  void choice(const std::string& key, Enum& field, const std::vector<std::pair<std::string, Enum>>& choices,
              const std::string& meaning);

  /// Accepts the name that a key had in the release before.
  void renamed(const std::string& former_key, const std::string& key);
  /// Accepts the name that a value of a choice had in the release before.
  void renamedChoice(const std::string& key, const std::string& former_name, const std::string& name);

  const std::vector<Setting>& settings() const { return settings_; }

  /// The setting of a key or former key; for the key of a table's entry, the table. Null if there is none.
  const Setting* find(const std::string& key) const;

  /// Sets the field of a key.
  /// @throws InvalidConfig if the key is unknown, naming the nearest one, or the value is not allowed
  void set(const std::string& key, const std::string& text);

  /// Checks the values that the fields hold now, also those that were not set through the schema.
  /// @throws InvalidConfig naming key, value and bound
  void validate() const;

 private:
  void addChoice(const std::string& key, const std::vector<std::string>& names, const std::string& meaning,
                 const std::function<void(std::size_t)>& choose, std::function<std::string()> get);

  std::vector<Setting> settings_;
  std::vector<std::pair<std::string, std::string>> former_keys_;  ///< former key, present key
};

/// The key of a setting and a value for it as text.
struct SettingText {
  std::string key;
  std::string text;
};

/// Reads a YAML document into dotted keys, in document order. An empty document gives none. A list of scalars
/// becomes one text, separated by commas. In any other list the key of an entry is its index, from 0.
/// @param source_name  names the document in errors
/// @throws InvalidConfig naming the line if it is not YAML, is not a map, or has a key twice
std::vector<SettingText> settingsFromYaml(const std::string& yaml, const std::string& source_name);

/// Sets the values of a YAML file, and after them `overrides`, in their order.
/// @param yaml_path  empty for no file
/// @throws InvalidConfig naming key, value and bound, and also the file if it is not YAML
/// @throws FileError if the file cannot be read
void applySettings(SettingsSchema& schema, const std::string& yaml_path,
                   const std::vector<SettingText>& overrides);

/// Splits an assignment "key=value".
/// @throws InvalidConfig if there is no '=' or no key
SettingText settingFromAssignment(const std::string& assignment);

/// The schema's current values as a commented YAML document, grouped by the first part of the key.
std::string settingsToYaml(const SettingsSchema& schema);

template <class Enum>
void SettingsSchema::choice(const std::string& key, Enum& field,
                            const std::vector<std::pair<std::string, Enum>>& choices,
                            const std::string& meaning) {
  std::vector<std::string> names;
  names.reserve(choices.size());
  for (const auto& choice : choices) names.push_back(choice.first);
  addChoice(
      key, names, meaning, [&field, choices](std::size_t i) { field = choices[i].second; },
      [&field, choices] {
        for (const auto& choice : choices)
          if (choice.second == field) return choice.first;
        return std::to_string(static_cast<long long>(field));
      });
}

}  // namespace lamina
