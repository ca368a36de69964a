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

/// A drop of a program.
struct ProgramDrop {
  Point3 position = Point3::Zero();  ///< [mm, machine]
  double feed_mm_s = 0.0;            ///< of the motion that led there
  std::optional<PathRole> role;      ///< as the program states
  std::size_t section = 0;           ///< counts the comments that state a role
  std::string command;               ///< that let it go
};

/// What must be known to put lines behind the last drop of a layer.
struct InsertionPoint {
  std::size_t offset = 0;         ///< in the text: behind the line of the last drop
  std::size_t line = 0;           ///< of the last drop, 1 based
  std::string role_comment;       ///< that holds there, with its semicolon; empty if none does
  std::string motion = "G1";      ///< command that holds for lines of coordinates alone; empty if an arc's
  Point2 shift = Point2::Zero();  ///< machine coordinates less those of the program [mm]
  double unit_mm = 1.0;
  bool is_absolute = true;
  bool is_shift_known = false;
};

/// The drops of one layer in the order of the program, and where new ones are put.
struct DropProgramLayer {
  std::vector<ProgramDrop> drops;
  std::optional<double> height_mm;  ///< as comments report
  InsertionPoint end;
};

/// A program for drops: its text as it is, and what it says.
struct DropProgram {
  std::string text;
  std::optional<double> diameter_mm;  ///< from the header, as the next two
  std::optional<double> layer_height_mm;
  std::string strategy;
  std::vector<DropProgramLayer> layers;  ///< those with drops
};

/// Whether the text is a program of drops: it has the header that reports their diameter, or a line that lets
/// one go.
bool isDropProgram(std::string_view text, const DropDialect& dialect);

/// Reads the text as GcodeReader does. Layers are those of the comments, and drops before the first are left
/// alone; without such comments a layer begins where a drop lies at another height.
/// @throws InvalidProgram naming the line: as GcodeReader; a drop before any motion; a header whose diameter
///   or height is no positive number or whose unit is not mm, or that states inclined layers
DropProgram parseDropProgram(std::string text, const DropDialect& dialect);

/// The text with new drops behind the last of each layer; everything else stays byte for byte. The lines go
/// there and back in the program's own units and coordinates, state the role of the new drops, restore the
/// role that held before, and let drops go by the command of the last infill drop of the layer, or of its
/// last drop.
/// @param added  centres for each layer [mm, machine]
/// @throws InvalidProgram naming the line if coordinates are relative (G91) or shifted in an unknown way
/// there, or lines of coordinates alone are arcs
std::string withDrops(const DropProgram& program, const std::vector<std::vector<Point2>>& added,
                      const DropDialect& dialect);

/// The toolpath that the program lays, as `ToolpathBuilder` does for beads: runs of drops of one role, joined
/// by travels. A layer's height is that of its comment, of the header, or what it rises over the one before.
/// @throws InvalidProgram if it holds no drop, or its header no diameter
Toolpath toolpathOf(const DropProgram& program, const std::string& part_name);

}  // namespace lamina
