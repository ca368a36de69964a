// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lamina/base/settings_schema.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The words of programs for drops. [Sobreviela2014, section 4.2] describes its programs, but its sample
/// of one is not at hand, so that each word is a setting.
struct DropDialect {
  std::string discharge = "M780";     ///< lets one drop go; parameters may follow it
  std::string layer_mark = "LAYER:";  ///< comment that opens a layer
  std::string role_mark = "TYPE:";    ///< comment that reports the role of the drops that follow
  std::string contour = "CONTOUR";    ///< roles
  std::string infill = "INFILL";
  std::string void_fill = "VOIDFILL";
  std::string diameter_key = "drop_diameter";  ///< comments key=value before the first layer [mm]
  std::string height_key = "layer_height";
  std::string strategy_key = "strategy";
  std::string units_key = "units";
};

/// Adds the keys drop_program.*.
void describe(SettingsSchema& schema, DropDialect& dialect);

/// Whether the command, without its comment, lets a drop go.
bool isDischarge(std::string_view command, const DropDialect& dialect);

/// The role as the dialect writes it: walls are contours, a gap fill is a void fill.
const std::string& roleName(PathRole role, const DropDialect& dialect);

/// The role of that name: outer wall, infill or gap fill; none if it is another one.
std::optional<PathRole> roleOf(std::string_view name, const DropDialect& dialect);

}  // namespace lamina
