// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lamina {

/// The slicer that wrote a G-code program, recognised by its comments.
enum class SlicerDialect : std::uint8_t {
  Unknown = 0,
  Lamina = 1,
  Cura = 2,
  PrusaSlicer = 3,
  Slic3r = 4,
  Simplify3d = 5,
  FullControl = 6
};

/// The name in files and messages: "simplify3d".
const char* toString(SlicerDialect dialect);

/// The slicer as far as it is known after a comment. A slicer names itself in the header; a program without
/// such a name, but with a FLAVOR line or the mark `kStartCodeEnds`, is FullControl's.
/// @param known  slicer as known before the comment
SlicerDialect dialectAfter(SlicerDialect known, std::string_view comment);

/// What the comments of a program state about the whole program.
struct ProgramNotes {
  SlicerDialect dialect = SlicerDialect::Unknown;
  std::optional<double> filament_diameter_mm;  ///< diameter of the filament that the program is for
};

/// Reads all comments of a program to its end, where some slicers state the filament.
ProgramNotes notesOf(std::string_view program);

/// Comments by which FullControl marks the end of its start code and the beginning of its end code.
inline constexpr std::string_view kStartCodeEnds = "END OF THE START GCODE";
inline constexpr std::string_view kEndCodeBegins = "START OF THE END GCODE";

}  // namespace lamina
