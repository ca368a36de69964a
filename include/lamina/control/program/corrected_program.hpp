// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/control/correction_map.hpp"
#include "lamina/gcode_rewrite/rewrite_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// How corrections are written into a program.
struct CorrectionWriting {
  double split_change = 0.02;        ///< change of amount or speed above which a line is split
  double place_tolerance_mm = 0.05;  ///< greatest distance of a program's motions from the toolpath
  int decimals = 3;                  ///< number of decimals of coordinates
  /// Whether E is absolute or relative until M82 or M83 says so; absolute if empty.
  std::optional<ExtrusionMode> initial_extrusion;
};

/// What was changed in a program.
struct CorrectionReport {
  std::size_t corrected_lines = 0;  ///< number of lines of depositing motions that were changed
  std::size_t added_lines = 0;      ///< number of lines added by splitting
  /// Number of lines that deposit beside the toolpath; they are left unchanged.
  std::size_t off_path_lines = 0;
  double planned_mm = 0.0;    ///< filament of the corrected lines before correction
  double corrected_mm = 0.0;  ///< filament of the corrected lines after correction
};

/// Writes corrections into G-code, line by line, so that a streamer can still correct the lines that it has
/// not sent. It changes E, F and the coordinate along the layers' normal. Where the correction changes along
/// a line, it splits the line; arcs are split into chords. A line without a correction keeps its bytes,
/// unless E is absolute and was changed before, or a changed feed or height has to be restored.
class ProgramCorrector {
 public:
  /// @param toolpath  the toolpath of the program, in coordinates of the program; must outlive this object
  /// @param maps      at most one per layer
  /// @throws InvalidInput as `validate` of a map; if a map is of another toolpath, two are of one layer, or
  ///   one shifts the nozzle by more than its layer's height; if `split_change` is not positive
  ProgramCorrector(const Toolpath& toolpath, const std::vector<CorrectionMap>& maps,
                   const CorrectionWriting& writing);
  ~ProgramCorrector();
  ProgramCorrector(const ProgramCorrector&) = delete;
  ProgramCorrector& operator=(const ProgramCorrector&) = delete;

  /// Adds the map of a layer whose lines have not been read yet.
  /// @throws InvalidInput as the constructor; if lines of the layer have been read
  void add(const CorrectionMap& map);

  /// Replaces the map of a layer from the next line on. Lines of the layer may have been read.
  /// @throws InvalidInput as the constructor, for the map
  void trim(const CorrectionMap& map);

  /// Reads a line of the program, and appends to `out` the line or lines that replace it, with a line feed
  /// after each but the last.
  /// @param line    without its line feed
  /// @param number  number of the line, for errors
  /// @throws InvalidProgram naming the line if it cannot be corrected: G91 or G20 within the part, an E that
  ///   firmwares interpret differently, or a checksum, which would become wrong
  void read(std::string_view line, std::size_t number, std::string& out);

  const CorrectionReport& report() const;

 private:
  class Writer;
  std::unique_ptr<Writer> writer_;
};

/// A map that replaces another map of its layer from a line of the program on.
struct LaterMap {
  std::size_t from_line = 0;  ///< number of the line, from 1
  CorrectionMap map;
};

/// A corrected program in memory.
struct CorrectedProgram {
  std::string text;
  CorrectionReport report;
};
/// Corrects a whole program. Without corrections in the maps the text stays the same to the byte.
/// @param trims  ascending by line; if several begin with the same line, the last one is valid
/// @throws InvalidInput, InvalidProgram as `ProgramCorrector`
CorrectedProgram correctedProgram(std::string_view program, const Toolpath& toolpath,
                                  const std::vector<CorrectionMap>& maps, const CorrectionWriting& writing,
                                  const std::vector<LaterMap>& trims = {});

}  // namespace lamina
