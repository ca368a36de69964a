// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/hooks/hook_code.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

const std::vector<std::string>& placeholderNames() {
  static const std::vector<std::string> names = {"layer",
                                                 "layers",
                                                 "z_mm",
                                                 "height_mm",
                                                 "time_s",
                                                 "left_s",
                                                 "share",
                                                 "role",
                                                 "part",
                                                 "tool",
                                                 "next_tool",
                                                 "nozzle_temperature_c",
                                                 "bed_temperature_c",
                                                 "x_mm",
                                                 "y_mm"};
  return names;
}

template <class Number>
Number numberOf(const std::string& key, const std::string& name, const std::string& expected) {
  Number value{};
  const char* const end = name.data() + name.size();
  const auto result = std::from_chars(name.data(), end, value);
  if (result.ec != std::errc{} || result.ptr != end)
    throw InvalidConfig(key + " has code at '" + name + "'; expected " + expected);
  return value;
}

void addTable(const std::string& key, const SettingTable& table, std::vector<HookCode>& codes) {
  for (const auto& [name, code] : table) codes.push_back({key + "." + name, code});
}

}  // namespace

std::vector<HookCode> hookCodes(const HookSettings& settings) {
  std::vector<HookCode> codes = {
      {"hooks.part_start", settings.part_start},   {"hooks.part_end", settings.part_end},
      {"hooks.layer_start", settings.layer_start}, {"hooks.layer_end", settings.layer_end},
      {"hooks.tool_change", settings.tool_change}, {"hooks.pause", settings.pause}};
  addTable("hooks.before_role", settings.before_role, codes);
  addTable("hooks.after_role", settings.after_role, codes);
  addTable("hooks.at_layer", settings.at_layer, codes);
  addTable("hooks.at_height_mm", settings.at_height_mm, codes);
  codes.erase(
      std::remove_if(codes.begin(), codes.end(), [](const HookCode& each) { return each.code.empty(); }),
      codes.end());
  return codes;
}

std::map<std::size_t, HookCode> layerHooks(const HookSettings& settings) {
  const std::string key = "hooks.at_layer";
  std::map<std::size_t, HookCode> hooks;
  for (const auto& [name, code] : settings.at_layer)
    hooks[numberOf<std::size_t>(key, name, "the number of a layer, from 0")] = {key + "." + name, code};
  return hooks;
}

std::map<double, HookCode> heightHooks(const HookSettings& settings) {
  const std::string key = "hooks.at_height_mm";
  std::map<double, HookCode> hooks;
  for (const auto& [name, code] : settings.at_height_mm) {
    const auto height_mm = numberOf<double>(key, name, "a height in mm");
    if (!(height_mm >= 0.0 && std::isfinite(height_mm)))
      throw InvalidConfig(key + " has code at '" + name + "'; expected a height in mm, 0 or more");
    hooks[height_mm] = {key + "." + name, code};
  }
  return hooks;
}

bool holdsAny(const std::string& code, const std::vector<std::string>& placeholders) {
  return std::any_of(placeholders.begin(), placeholders.end(), [&code](const std::string& name) {
    return code.find("{" + name + "}") != std::string::npos;
  });
}

void requirePlaceholders(const std::string& key, const std::string& code) {
  expandPlaceholders(key, code, [&key](const std::string& name) {
    const std::vector<std::string>& names = placeholderNames();
    if (std::find(names.begin(), names.end(), name) == names.end())
      throw InvalidConfig(key + " holds the placeholder {" + name + "}; must be one of " + listed(names));
    return std::string("0");
  });
}

}  // namespace lamina
