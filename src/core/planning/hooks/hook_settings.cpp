// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/hooks/hook_settings.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/hooks/hook_code.hpp"

namespace lamina {
namespace {

constexpr std::ptrdiff_t kMostLines = 1000;
constexpr std::string_view kMoving[] = {"G0",  "G1",  "G2",  "G3",  "G5",  "G20", "G21", "G28",
                                        "G29", "G30", "G90", "G91", "G92", "M82", "M83"};

/// The first line that moves axes, or changes what their words mean; empty if there is none.
std::string movingLine(const std::string& code) {
  for (std::size_t begin = 0; begin < code.size();) {
    const std::size_t end = std::min(code.find('\n', begin), code.size());
    std::string line = code.substr(begin, end - begin);
    const std::size_t first = std::min(line.find_first_not_of(" \t"), line.size());
    const std::string word = line.substr(first, line.find_first_of(" \t;", first) - first);
    if (std::find(std::begin(kMoving), std::end(kMoving), word) != std::end(kMoving)) return line;
    begin = end + 1;
  }
  return {};
}

void requireFit(const std::string& key, const std::string& code, const HookSettings& settings) {
  if (code.find('\r') != std::string::npos)
    throw InvalidConfig(key + " holds a carriage return; expected lines ended by line feeds");
  // A block of YAML ends its last line, too.
  const std::ptrdiff_t unended = code.empty() || code.back() == '\n' ? 0 : 1;
  const std::ptrdiff_t lines = std::count(code.begin(), code.end(), '\n') + unended;
  if (lines > kMostLines)
    throw InvalidConfig(key + " has " + std::to_string(lines) + " lines; expected at most " +
                        std::to_string(kMostLines));
  requirePlaceholders(key, code);
  const std::string moving = settings.moves_axes ? "" : movingLine(code);
  if (!moving.empty())
    throw InvalidConfig(key + " holds '" + moving +
                        "', which moves axes or changes modes; expected hooks.moves true");
}

void requireRoles(const std::string& key, const SettingTable& table) {
  for (const auto& [name, code] : table) {
    PathRole role = PathRole::Travel;
    try {
      role = pathRoleFromString(name);
    } catch (const InvalidInput& error) {
      throw InvalidConfig(key + "." + name + ": " + error.what());
    }
    if (role == PathRole::Travel)
      throw InvalidConfig(key + ".travel: a travel lays nothing; expected a role that does");
  }
}

}  // namespace

void describe(SettingsSchema& schema, HookSettings& hooks) {
  schema.text("hooks.part_start", hooks.part_start, "Code before the part's first motion.");
  schema.text("hooks.part_end", hooks.part_end, "Code behind the part's last motion.");
  schema.text("hooks.layer_start", hooks.layer_start, "Code before the first bead of each layer.");
  schema.text("hooks.layer_end", hooks.layer_end, "Code behind the last motion of each layer.");
  schema.text("hooks.tool_change", hooks.tool_change, "Code behind each change of tools.");
  schema.text("hooks.pause", hooks.pause, "Code before the machine waits for its operator.");
  schema.table("hooks.before_role", hooks.before_role, "Code before beads of a role, by its name.");
  schema.table("hooks.after_role", hooks.after_role, "Code behind beads of a role, by its name.");
  schema.table("hooks.at_layer", hooks.at_layer,
               "Code before the first bead of a layer, by its number from 0.");
  schema.table("hooks.at_height_mm", hooks.at_height_mm,
               "Code once material has reached a height over the bed, before the next layer.");
  schema.flag("hooks.moves", hooks.moves_axes,
              "Whether this code moves axes: then position, modes and feed are stated again behind it.");
}

void describe(SettingsSchema& schema, PauseSettings& pauses) {
  schema.list("pause.at_layers", pauses.at_layers, {0.0, 1e7},
              "Layers, by their numbers from 0, before which the machine waits for its operator.");
  schema.list("pause.at_heights_mm", pauses.at_heights_mm, {0.0, 1e5},
              "Heights over the bed that material has reached when the machine waits.");
}

void requireConsistent(const HookSettings& settings) {
  for (const HookCode& hook : hookCodes(settings)) requireFit(hook.key, hook.code, settings);
  requireRoles("hooks.before_role", settings.before_role);
  requireRoles("hooks.after_role", settings.after_role);
  layerHooks(settings);
  heightHooks(settings);
}

void requireConsistent(const PauseSettings& settings) {
  for (const double layer : settings.at_layers)
    if (layer != std::floor(layer))
      throw InvalidConfig("pause.at_layers holds " + numberText(layer) + "; must be whole numbers");
}

}  // namespace lamina
