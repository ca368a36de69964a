// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace lamina {

/// Whose comments a G-code program carries.
enum class SlicerDialect : std::uint8_t {
  Unknown = 0,
  Lamina = 1,
  Cura = 2,
  PrusaSlicer = 3,
  Slic3r = 4,
  Simplify3d = 5,
  FullControl = 6
};

/// As written in files and shown to people: "simplify3d".
const char* toString(SlicerDialect dialect);

/// The dialect after a comment was read, given the dialect known before it: a slicer names itself in
/// the header; a program with a FLAVOR line, or with marks about its start code, that names none is
/// FullControl's.
SlicerDialect dialectAfter(SlicerDialect known, std::string_view comment);

/// What the comments of a program state about the whole program.
struct ProgramNotes {
  SlicerDialect dialect = SlicerDialect::Unknown;
  std::optional<double> filament_diameter_mm;  ///< of the filament it was made for
};

/// Reads the comments of a program: all of them, for slicers report the filament at the end.
ProgramNotes notesOf(std::string_view program);

/// Comments with which FullControl closes its start code and opens its end code.
inline constexpr std::string_view kStartCodeEnds = "END OF THE START GCODE";
inline constexpr std::string_view kEndCodeBegins = "START OF THE END GCODE";

}  // namespace lamina
