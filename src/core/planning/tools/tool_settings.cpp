// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/tools/tool_settings.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr std::size_t kMostTools = 64;

/// Keys of one tool.
void describeTool(SettingsSchema& schema, Tool& tool, std::vector<double>& offset) {
  schema.text("name", tool.name, "");
  schema.numbers("offset_mm", offset, 3, "");
  schema.number("nozzle_mm", tool.nozzle_mm, {0.0, 100.0}, "");
  schema.text("material", tool.material, "");
  schema.number("temperature_c", tool.temperature_c, {0.0, 500.0}, "");
  schema.number("standby_c", tool.standby_c, {0.0, 500.0}, "");
  schema.number("heat_s", tool.heat_s, {0.0, 1e4}, "");
}

/// An entry "0.name" as the number of its tool and the key.
std::pair<std::size_t, std::string> entryOf(const std::string& name) {
  std::size_t index = 0;
  const std::size_t dot = std::min(name.find('.'), name.size());
  const auto result = std::from_chars(name.data(), name.data() + dot, index);
  if (result.ec != std::errc{} || result.ptr != name.data() + dot || dot == name.size() ||
      index >= kMostTools)
    throw InvalidConfig("tools.list." + name +
                        " is no tool's; expected a list of tools with name, offset_mm, nozzle_mm, material, "
                        "temperature_c, standby_c or heat_s");
  return {index, name.substr(dot + 1)};
}

/// The roles' tools with their keys.
std::array<std::pair<const char*, int>, 5> assigned(const ToolSettings& settings) {
  return {{{"tool.walls", settings.walls},
           {"tool.infill", settings.infill},
           {"tool.skin", settings.skin},
           {"tool.support", settings.support},
           {"tool.interface", settings.interface}}};
}

}  // namespace

void describe(SettingsSchema& schema, ToolSettings& settings) {
  const Bounds tool{0.0, 63.0};
  schema.integer("tool.walls", settings.walls, tool, "Tool that lays walls, by its number from 0.");
  schema.integer("tool.infill", settings.infill, tool, "Tool that lays infill.");
  schema.integer("tool.skin", settings.skin, tool, "Tool that lays skins, bridges and ironing.");
  schema.integer("tool.support", settings.support, {-1.0, 63.0},
                 "Tool that lays supports, brims and rafts; -1 is that of walls.");
  schema.integer("tool.interface", settings.interface, {-1.0, 63.0},
                 "Tool that lays what lies between supports and part; -1 is that of supports.");
  schema.table(
      "tools.list", settings.list,
      "The machine's tools: a list of name, offset_mm, nozzle_mm, material, temperature_c, standby_c, "
      "heat_s.");
  schema.list(
      "tools.purge_mm3", settings.purge_mm3, {0.0, 1e6},
      "Volume that a tool lays into the prime tower when it is taken: one number, or one for each pair "
      "of tools, row by row of the tool before; none for no tower.");
  schema.flag(
      "tools.purge_into_infill", settings.purge_into_infill,
      "Whether a tool that is taken lays infill first, and only the rest of its purge into the tower.");
  schema.number("tools.tower_mm", settings.tower_mm, {0.0, 1000.0},
                "Side of the prime tower; 0 is as wide as its purges need.");
  schema.numbers("tools.tower_at_mm", settings.tower_at_mm, 2,
                 "Middle of the prime tower in the part's frame, x and y; empty is beside the part.");
}

std::vector<Tool> toolsOf(const ToolSettings& settings) {
  std::size_t count = 0;
  for (const auto& [name, text] : settings.list) count = std::max(count, entryOf(name).first + 1);
  std::vector<Tool> tools(count);
  std::vector<std::vector<double>> offsets(count);
  std::vector<bool> is_listed(count, false);
  for (const auto& [name, text] : settings.list) {
    const auto [index, key] = entryOf(name);
    SettingsSchema schema;
    describeTool(schema, tools[index], offsets[index]);
    try {
      schema.set(key, text);
    } catch (const InvalidConfig& error) {
      throw InvalidConfig("tools.list, tool " + std::to_string(index) + ": " + error.what());
    }
    is_listed[index] = true;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_listed[i])
      throw InvalidConfig("tools.list has no tool " + std::to_string(i) + ", but one behind it");
    if (!offsets[i].empty()) tools[i].offset_mm = {offsets[i][0], offsets[i][1], offsets[i][2]};
  }
  return tools;
}

std::vector<Point3> toolOffsets(const ToolSettings& settings) {
  const std::vector<Tool> tools = toolsOf(settings);
  std::vector<Point3> offsets_mm;
  offsets_mm.reserve(tools.size());
  for (const Tool& tool : tools) offsets_mm.push_back(tool.offset_mm);
  return offsets_mm;
}

std::size_t toolFor(PathRole role, const ToolSettings& settings) {
  const int support = settings.support < 0 ? settings.walls : settings.support;
  switch (role) {
    case PathRole::Infill:
      return static_cast<std::size_t>(settings.infill);
    case PathRole::TopSkin:
    case PathRole::Skin:
    case PathRole::BottomSkin:
    case PathRole::Bridge:
    case PathRole::Ironing:
      return static_cast<std::size_t>(settings.skin);
    case PathRole::Support:
    case PathRole::Brim:
    case PathRole::Raft:
      return static_cast<std::size_t>(support);
    case PathRole::SupportInterface:
      return static_cast<std::size_t>(settings.interface < 0 ? support : settings.interface);
    default:
      return static_cast<std::size_t>(settings.walls);
  }
}

bool assignsTools(const ToolSettings& settings) {
  const auto all = assigned(settings);
  return std::any_of(all.begin(), all.end(), [](const auto& each) { return each.second > 0; });
}

void requireConsistent(const ToolSettings& settings) {
  const std::vector<Tool> tools = toolsOf(settings);
  const std::size_t count = std::max<std::size_t>(tools.size(), 1);
  for (const auto& [key, tool] : assigned(settings))
    if (tool >= static_cast<int>(count))
      throw InvalidConfig(std::string(key) + " is " + std::to_string(tool) + "; tools.list has " +
                          std::to_string(tools.size()) + " tools, counted from 0");
  const std::size_t volumes = settings.purge_mm3.size();
  if (volumes > 1 && volumes != count * count)
    throw InvalidConfig("tools.purge_mm3 has " + std::to_string(volumes) + " volumes; expected one, or " +
                        std::to_string(count * count) + " for each pair of " + std::to_string(count) +
                        " tools");
  if (settings.purge_into_infill && volumes == 0)
    throw InvalidConfig(
        "tools.purge_into_infill is true and tools.purge_mm3 has no volume; expected one: there is nothing "
        "to "
        "purge");
}

}  // namespace lamina
