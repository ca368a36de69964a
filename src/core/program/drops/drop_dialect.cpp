// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/drops/drop_dialect.hpp"

namespace lamina {

void describe(SettingsSchema& schema, DropDialect& dialect) {
  schema.text("drop_program.discharge", dialect.discharge, "Command that lets one drop go.");
  schema.text("drop_program.layer_mark", dialect.layer_mark, "Comment that opens a layer.");
  schema.text("drop_program.role_mark", dialect.role_mark, "Comment that states the role of drops.");
  schema.text("drop_program.contour", dialect.contour, "Role of drops along contours.");
  schema.text("drop_program.infill", dialect.infill, "Role of drops inside contours.");
  schema.text("drop_program.void_fill", dialect.void_fill, "Role of drops that fill voids.");
  schema.text("drop_program.diameter_key", dialect.diameter_key,
              "Key of the diameter of drops in the header [mm].");
  schema.text("drop_program.height_key", dialect.height_key,
              "Key of the height of layers in the header [mm].");
  schema.text("drop_program.strategy_key", dialect.strategy_key, "Key of the fill's name in the header.");
  schema.text("drop_program.units_key", dialect.units_key,
              "Key of the unit of length in the header, which must be mm.");
}

bool isDischarge(std::string_view command, const DropDialect& dialect) {
  const std::string_view word = dialect.discharge;
  if (word.empty() || command.substr(0, word.size()) != word) return false;
  return command.size() == word.size() || command[word.size()] == ' ' || command[word.size()] == '\t';
}

const std::string& roleName(PathRole role, const DropDialect& dialect) {
  switch (role) {
    case PathRole::OuterWall:
    case PathRole::InnerWall:
      return dialect.contour;
    case PathRole::GapFill:
      return dialect.void_fill;
    default:
      return dialect.infill;
  }
}

std::optional<PathRole> roleOf(std::string_view name, const DropDialect& dialect) {
  if (name == dialect.contour) return PathRole::OuterWall;
  if (name == dialect.infill) return PathRole::Infill;
  if (name == dialect.void_fill) return PathRole::GapFill;
  return std::nullopt;
}

}  // namespace lamina
