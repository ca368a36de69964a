// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "lamina/program/gcode/gcode_reader.hpp"
#include "lamina/program/program_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Builds the toolpath that a program prints, in coordinates of the bed, from its motions. Coordinates of the
/// program are those of the bed unless comments state another frame.
///
/// A toolpath begins where the program first states a position, or deposits: travels from elsewhere
/// (`GcodeMotion::is_start_stated`) are left out.
///
/// A motion that extrudes deposits; every other one is a travel, which is retracted if filament was retracted
/// and not extruded again yet. A path ends where kind, role or tool change, where a comment opens a path or
/// layer, and where filament moves alone; a deposition that ends where it started is closed. Layers are those
/// of the slicer's comments, and everything before the first and after the last of them is left out. Without
/// comments, a layer begins wherever material is deposited at another height. The height of a bead is that of
/// the last comment before its motion, otherwise the thickness of the layer. In a program with FullControl's
/// marks, exactly what is between them belongs to the part. A bead is as wide as the stadium with the volume
/// deposited per length. A path gets a single width if that explains all its motions within the rounding of a
/// program (1e-5 mm of filament, 1.75e-3 mm of length). Dwells, pauses, names of parts and shares of the
/// first fan (P0) within the part become events; other codes are left out. A filament diameter stated by
/// comments takes precedence over that of the settings.
class ToolpathBuilder {
 public:
  /// @param settings  only filament diameter and flow are used
  explicit ToolpathBuilder(const ProgramSettings& settings);
  ~ToolpathBuilder();

  /// Reads a comment. A comment has an effect if it states the program's frame (`readFrameComment`), which
  /// must precede the motions; states the filament, a tool's offset or the name of a part; or marks the end
  /// of the start code or the beginning of the end code.
  void readComment(std::string_view comment);
  void add(const GcodeMotion& motion);
  /// Adds an event before the next motion; after the last motion it becomes an event at the end.
  void add(ToolpathEvent event);
  /// Makes this the tool of the motions that follow.
  void changeTool(std::uint32_t tool);
  /// The toolpath so far; the builder is empty afterwards.
  Toolpath finish(const std::string& part_name);

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// Reads a program that is held in memory. If it releases drops by the command of `settings.drops`, it is
/// read as a program of drops: see `drop_program.hpp`.
/// @throws InvalidProgram naming the line; also if nothing in it moves
Toolpath toolpathFromGcode(std::string_view program, const ProgramSettings& settings,
                           const std::string& part_name);

/// Reads a file piece by piece; the toolpath is named after it.
/// @throws FileError if it cannot be read
/// @throws InvalidProgram naming the line; also if nothing in it moves
Toolpath toolpathFromGcodeFile(const std::string& path, const ProgramSettings& settings);

/// Width [mm] of the stadium of this area and height, which stands upright if it is higher than wide; 0 if
/// the area is 0.
/// @param area_mm2  not negative
/// @param height_mm  positive
double beadWidth(double area_mm2, double height_mm);

}  // namespace lamina
