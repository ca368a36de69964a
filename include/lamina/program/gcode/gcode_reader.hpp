// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "lamina/geometry/vector.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A straight motion of a program, in machine coordinates. An arc is read as a sequence of such motions.
struct GcodeMotion {
  Point3 start = Point3::Zero();  ///< [mm]
  Point3 end = Point3::Zero();    ///< [mm]; equal to the start for a motion of the filament alone
  double extrusion_mm = 0.0;      ///< length of filament extruded; negative if it is retracted
  double feed_mm_s = 0.0;
  std::size_t line = 0;                   ///< 1 based
  std::optional<int> layer;               ///< layer by the slicer's comments; nothing before the first layer
  std::optional<PathRole> role;           ///< as the slicer's comments state
  std::optional<double> height_mm;        ///< height of the bead, as the slicer's comments state
  std::optional<double> layer_height_mm;  ///< first `height_mm` of the layer, or that of the layer before
  std::size_t section = 0;                ///< number of comments so far that open a layer or a path
  /// Whether the program has stated the start along the axes that move: by absolute coordinates, by homing or
  /// by G92. Otherwise the machine may come from anywhere.
  bool is_start_stated = true;
};

/// Functions that are called for motions, dwells, other commands and comments, in the order of the program.
/// An empty function is not called.
struct GcodeHandlers {
  std::function<void(const GcodeMotion&)> motion;
  std::function<void(std::size_t line, double seconds)> dwell;  ///< G4
  /// Called for heaters, fans, tools, homing, and unknown commands.
  std::function<void(std::size_t line, std::string_view command)> other;
  std::function<void(std::string_view)> comment = {};  ///< called without its semicolon or brackets
};

struct GcodeReaderSettings {
  double chord_tolerance_mm = 0.01;  ///< greatest distance between an arc and the motions that replace it
  double initial_feed_mm_s = 25.0;   ///< feed until the first F word, as in Marlin
};

/// Reads a program by interpreting its modal state (Marlin's dialect of RS-274), piece by piece, in constant
/// memory.
///
/// Understood: G0, G1, arcs G2 and G3 by I J K or R in the planes of G17 G18 G19 (helices too), G4, G20, G21,
/// G28 (homes to 0), G90 and G91 (which set extrusion too, as in Marlin), G92, M82, M83, lines of coordinates
/// alone, N, *, and comments. Positions are taken to be 0 until they are stated; they are absolute, in mm.
class GcodeReader {
 public:
  GcodeReader(GcodeReaderSettings settings, GcodeHandlers handlers);
  ~GcodeReader();
  GcodeReader(GcodeReader&&) noexcept;
  GcodeReader& operator=(GcodeReader&&) noexcept;

  /// Reads the next piece, which may end within a line.
  /// @throws InvalidProgram naming the line: for a number that is malformed, not finite or too large, a word
  ///   without a value or given twice, a feed that is not positive, an arc without centre or off its circle,
  ///   two motions in one line, a spline (G5, G6), a rotary axis, or a line longer than 1 MiB
  void read(std::string_view piece);
  /// Reads what remains of the last line.
  void finish();

 private:
  class Interpreter;
  std::unique_ptr<Interpreter> interpreter_;
  std::string unfinished_;
  std::size_t line_ = 0;
};

/// Reads a whole file.
/// @throws FileError if it cannot be read
/// @throws InvalidProgram as above
void readGcodeFile(const std::string& path, const GcodeReaderSettings& settings,
                   const GcodeHandlers& handlers);

}  // namespace lamina
