// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "lamina/geometry/vector.hpp"
#include "lamina/program/drops/drop_dialect.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A drop that a program releases.
struct ProgramDrop {
  Point3 position = Point3::Zero();  ///< [mm], machine coordinates
  double feed_mm_s = 0.0;            ///< feed of the motion to the position
  std::optional<PathRole> role;      ///< as comments state
  std::size_t section = 0;           ///< number of comments so far that state a role
  std::string command;               ///< command that releases the drop
};

/// A position in the text at which lines can be inserted after the last drop of a layer, with the modal state
/// there.
struct InsertionPoint {
  std::size_t offset = 0;    ///< bytes of the text up to the end of the last drop's line
  std::size_t line = 0;      ///< number of the last drop's line, 1 based
  std::string role_comment;  ///< last comment that states a role, with its semicolon; empty if there is none
  /// The motion command that a line with coordinates alone repeats: G0 or G1; empty if it would repeat an
  /// arc.
  std::string motion = "G1";
  Point2 shift = Point2::Zero();  ///< machine coordinates minus program coordinates [mm]
  double unit_mm = 1.0;           ///< length of the program's unit: 1, or 25.4 after G20
  bool is_absolute = true;        ///< whether coordinates are absolute (G90) or relative (G91)
  bool is_shift_known = false;    ///< whether x and y were both stated since the last G28 or G92
};

/// The drops of one layer in the order of the program, and where new ones can be inserted.
struct DropProgramLayer {
  std::vector<ProgramDrop> drops;
  std::optional<double> height_mm;  ///< as comments state
  InsertionPoint end;
};

/// A program that deposits drops: its unchanged text, and what is read from it.
struct DropProgram {
  std::string text;
  std::optional<double> diameter_mm;  ///< diameter of drops; from the header, as the next two
  std::optional<double> layer_height_mm;
  std::string strategy;
  std::vector<DropProgramLayer> layers;  ///< layers that have drops
};

/// Whether the text is a program of drops: its header states their diameter, or one of its lines releases a
/// drop.
bool isDropProgram(std::string_view text, const DropDialect& dialect);

/// Reads the text as GcodeReader does. Layers are those of the comments; drops before the first layer and
/// after the comment "end of the part" are left out. Without such comments, a layer begins wherever a drop is
/// at another height than the previous drop.
/// @throws InvalidProgram naming the line: as GcodeReader; a drop before any motion; a header whose diameter
///   or height is no positive number or whose unit is not mm, or that states inclined layers
DropProgram parseDropProgram(std::string text, const DropDialect& dialect);

/// The text with new drops inserted after the last drop of each layer; everything else stays byte for byte.
/// The inserted lines are in the program's own units and coordinates. They state the role of void fill, move
/// to each new drop and release it, move back to the last drop, and restore the role. Drops are released by
/// the command of the layer's last infill drop, or of its last drop if it has no infill.
/// @param added  centres of the new drops of each layer [mm, machine]; layers beyond its last entry get none
/// @throws InvalidInput if there are more entries than layers
/// @throws InvalidProgram naming the line if, where drops are to be inserted, coordinates are relative (G91)
///   or have an unknown shift, or lines of coordinates alone are arcs
std::string withDrops(const DropProgram& program, const std::vector<std::vector<Point2>>& added,
                      const DropDialect& dialect);

/// The toolpath of the program: a path of drops from each comment that states a role to the next, with
/// travels between the paths. The thickness of a layer is stated by the layer's comments, otherwise by the
/// header; otherwise it is the layer's height above the layer before.
/// @throws InvalidProgram if the program has no drop, or its header states no diameter
Toolpath toolpathOf(const DropProgram& program, const std::string& part_name);

}  // namespace lamina
