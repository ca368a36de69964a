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

/// Builds the toolpath that a program prints, in coordinates of the bed, from its motions. These are those of
/// the program unless its comments state another frame.
///
/// A motion that pushes filament forth deposits; every other is travel, which is retracted from where
/// filament is pulled back alone until it is pushed forth alone. A path ends where kind or role change, where
/// a comment opens a path or layer, and at retractions; deposition that ends where it started is closed.
/// Layers are those of the slicer's comments, and what comes before the first and after the last of them is
/// left out; without comments a layer begins wherever material is deposited at another height. Bead height is
/// that of the comments, motion by motion, or of the layer. Between FullControl's marks everything is of the
/// part, outside them nothing. Bead width is that of the stadium which holds the volume deposited per length.
/// Where one width explains a path within the rounding of a program (1e-5 mm of filament, 1e-3 mm of length)
/// the path has one width. Dwells, the first fan and pauses within the part are events; other codes are left
/// out. A filament diameter that the comments report goes before that of the settings.
class ToolpathBuilder {
 public:
  /// Of the settings, filament diameter and flow are used.
  explicit ToolpathBuilder(const ProgramSettings& settings);
  ~ToolpathBuilder();

  /// Takes in a comment that may report the program's frame (`readFrameComment`), which stands before the
  /// motions, the filament, or where the start code ends and the end code begins.
  void readComment(std::string_view comment);
  void add(const GcodeMotion& motion);
  /// Happens before the next motion; after the last one it is an event at the end.
  void add(ToolpathEvent event);
  /// Runs the motions that follow.
  void changeTool(std::uint32_t tool);
  /// The toolpath so far; the builder is empty afterwards.
  Toolpath finish(const std::string& part_name);

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// Reads a program that is held in memory. If it lets drops go (settings.drops), it is one of drops: see
/// `drop_program.hpp`.
/// @throws InvalidProgram naming the line; also if nothing in it moves
Toolpath toolpathFromGcode(std::string_view program, const ProgramSettings& settings,
                           const std::string& part_name);

/// Reads a file piece by piece; the toolpath is named after it.
/// @throws FileError if it cannot be read
/// @throws InvalidProgram naming the line; also if nothing in it moves
Toolpath toolpathFromGcodeFile(const std::string& path, const ProgramSettings& settings);

/// Width of the stadium of this height and area; 0 if the area is 0.
/// @param area_mm2, height_mm  positive
double beadWidth(double area_mm2, double height_mm);

}  // namespace lamina
