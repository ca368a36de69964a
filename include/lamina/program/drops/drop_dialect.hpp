// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lamina/base/settings_schema.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The words of programs that deposit drops: a command, comments and keys of the header. They are settings,
/// because [Sobreviela2014, section 4.2] describes such programs, but its sample is not available.
struct DropDialect {
  std::string discharge = "M780";      ///< command that releases one drop; parameters may follow it
  std::string layer_mark = "LAYER:";   ///< comment that opens a layer
  std::string role_mark = "TYPE:";     ///< comment that states the role of the drops that follow
  std::string contour = "CONTOUR";     ///< role of drops along contours
  std::string infill = "INFILL";       ///< role of drops inside contours
  std::string void_fill = "VOIDFILL";  ///< role of drops that fill voids
  /// Key of the drops' diameter [mm] in the header. The header consists of comments key=value.
  std::string diameter_key = "drop_diameter";
  std::string height_key = "layer_height";  ///< key of the layers' height [mm]
  std::string strategy_key = "strategy";    ///< key of the name of the infill strategy
  std::string units_key = "units";          ///< key of the unit of length, which must be mm
};

/// Adds the keys drop_program.*.
void describe(SettingsSchema& schema, DropDialect& dialect);

/// Whether the command, given without its comment, releases a drop.
bool isDischarge(std::string_view command, const DropDialect& dialect);

/// The name of a role in the dialect: `contour` for walls, `void_fill` for gap fills, `infill` for all other
/// roles.
const std::string& roleName(PathRole role, const DropDialect& dialect);

/// The path role that has this name in the dialect: outer wall, infill or gap fill; nothing for any other
/// name.
std::optional<PathRole> roleOf(std::string_view name, const DropDialect& dialect);

}  // namespace lamina
