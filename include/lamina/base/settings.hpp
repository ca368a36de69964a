// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace lamina {

/// Bounds of a numeric setting, both included unless said otherwise.
struct Bounds {
  double low = 0.0;
  double high = 0.0;
  bool excludes_low = false;
};

/// One configuration key bound to the field that holds it. Values travel as text, as they stand in YAML, in
/// `--set` and in a ROS request.
struct Setting {
  std::string key;  ///< dotted, unit last: "slicing.layer_height_mm"
  /// "number", "integer", "flag", "text", "3 numbers", "numbers", "table", or the choices "a | b | c"
  std::string type;
  std::string bounds;   ///< as a person reads it: "(0, 10]"; empty if there are none
  std::string meaning;  ///< one sentence
  std::function<void(const std::string& text)> set;  ///< throws InvalidConfig naming key, value and bound
  std::function<std::string()> get;
  /// Of a table: sets one entry. Empty for others.
  std::function<void(const std::string& entry, const std::string& text)> set_entry = {};
};

/// Texts by their names: what a map, or a list of maps, in YAML holds. A name is what stands behind the
/// table's key, with dots: "12", "0.nozzle_mm".
using SettingTable = std::map<std::string, std::string>;

/// The settings of one or more stages: each stage's `describe(schema, settings)` adds its own keys. The bound
/// structs must outlive the schema.
class SettingsSchema {
 public:
  void number(const std::string& key, double& field, Bounds bounds, const std::string& meaning);
  void integer(const std::string& key, int& field, Bounds bounds, const std::string& meaning);
  void flag(const std::string& key, bool& field, const std::string& meaning);
  void text(const std::string& key, std::string& field, const std::string& meaning);
  /// Finite numbers with commas between them, `count` of them or none.
  void numbers(const std::string& key, std::vector<double>& field, std::size_t count,
               const std::string& meaning);
  /// Any count of numbers within bounds, with commas between them.
  void list(const std::string& key, std::vector<double>& field, Bounds bounds, const std::string& meaning);
  /// Entries by any name, each settable as `key.name`; as text, all of them as a YAML map or list in one line
  /// ("{12: M117 nuts}").
  void table(const std::string& key, SettingTable& field, const std::string& meaning);
  /// A text that must be one of `choices`.
  void choice(const std::string& key, std::string& field, const std::vector<std::string>& choices,
              const std::string& meaning);
  /// An enumeration by its names.
  template <class Enum>
  void choice(const std::string& key, Enum& field, const std::vector<std::pair<std::string, Enum>>& choices,
              const std::string& meaning);

  /// A key, or one value of a choice, that had another name in the release before: that name is still taken.
  void renamed(const std::string& former_key, const std::string& key);
  void renamedChoice(const std::string& key, const std::string& former_name, const std::string& name);

  const std::vector<Setting>& settings() const { return settings_; }

  /// The setting of a key or of a former name of it, or the table that the key is an entry of; null if there
  /// is none.
  const Setting* find(const std::string& key) const;

  /// @throws InvalidConfig if the key is unknown (names the nearest one) or the value does not fit
  void set(const std::string& key, const std::string& text);

  /// Checks what the fields hold now, however it came there.
  /// @throws InvalidConfig naming key, value and bound
  void validate() const;

 private:
  void addChoice(const std::string& key, const std::vector<std::string>& names, const std::string& meaning,
                 const std::function<void(std::size_t)>& choose, std::function<std::string()> get);

  std::vector<Setting> settings_;
  std::vector<std::pair<std::string, std::string>> former_keys_;  ///< and what each is now
};

/// A key and its value as text.
struct SettingText {
  std::string key;
  std::string text;
};

/// Reads a YAML document into dotted keys, in document order. An empty document gives nothing. A list of
/// single values is one text with commas; entries of other lists have their number as key.
/// @throws InvalidConfig if it is not YAML, not a map, or a key stands twice; names the line
std::vector<SettingText> settingsFromYaml(const std::string& yaml, const std::string& source_name);

/// Sets what a YAML file holds, and then `overrides`, in order.
/// @param yaml_path  empty for none
/// @throws InvalidConfig naming key, value and bound (and the file, if it is no YAML); FileError
void applySettings(SettingsSchema& schema, const std::string& yaml_path,
                   const std::vector<SettingText>& overrides);

/// Splits "key=value".
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
