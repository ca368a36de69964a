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
  double split_change = 0.02;        ///< change of the amount above which a line is split
  double place_tolerance_mm = 0.05;  ///< greatest distance of a program's motions from the toolpath
  int decimals = 3;                  ///< of coordinates
  /// Mode of E until M82 or M83 sets it; if empty, absolute.
  std::optional<ExtrusionMode> initial_extrusion;
};

/// The changes of a program.
struct CorrectionReport {
  std::size_t corrected_lines = 0;  ///< lines of depositing motions that were changed
  std::size_t added_lines = 0;      ///< by splitting
  std::size_t off_path_lines = 0;   ///< lines that deposit beside the toolpath; left unchanged
  double planned_mm = 0.0;          ///< filament of the corrected lines before
  double corrected_mm = 0.0;        ///< filament of the corrected lines after
};

/// Writes corrections into G-code, line by line, so that a streamer can correct lines that are not sent yet.
/// It changes E, F and the axis along the layers' normal, and splits lines, and arcs into chords, where the
/// amount changes. A line without a correction keeps its bytes, unless E is absolute and was changed before,
/// or a changed feed or height has to be restored.
class ProgramCorrector {
 public:
  /// @param toolpath  of which the program was written, in coordinates of the program; must outlive this
  /// @param maps      at most one per layer
  /// @throws InvalidInput as `validate`; if a map is of another toolpath, or two are of one layer, or one
  ///   shifts the nozzle by more than its layer's height; if the change at which lines are split is not
  ///   positive
  ProgramCorrector(const Toolpath& toolpath, const std::vector<CorrectionMap>& maps,
                   const CorrectionWriting& writing);
  ~ProgramCorrector();
  ProgramCorrector(const ProgramCorrector&) = delete;
  ProgramCorrector& operator=(const ProgramCorrector&) = delete;

  /// Adds the map of a layer of which nothing was read yet.
  /// @throws InvalidInput as the constructor; if the layer has begun
  void add(const CorrectionMap& map);

  /// Replaces the map of a layer from the next line on. Part of the layer may have been read.
  /// @throws InvalidInput as the constructor
  void trim(const CorrectionMap& map);

  /// Appends the lines that a line becomes, with a line feed after each but the last.
  /// @param line  without its line feed
  /// @throws InvalidProgram naming the line, if it cannot be corrected: G91 or G20 within the part, an E that
  ///   firmwares read differently, a checksum, which would no longer hold
  void read(std::string_view line, std::size_t number, std::string& out);

  const CorrectionReport& report() const;

 private:
  class Writer;
  std::unique_ptr<Writer> writer_;
};

/// A map that replaces the one of its layer, from a line on.
struct LaterMap {
  std::size_t from_line = 0;  ///< of the program, from 1
  CorrectionMap map;
};

/// A corrected program in memory.
struct CorrectedProgram {
  std::string text;
  CorrectionReport report;
};
/// Corrects a whole program. Maps without corrections give the same bytes.
/// @param trims  ascending by line; of those of one line the last one holds
/// @throws as `ProgramCorrector`
CorrectedProgram correctedProgram(std::string_view program, const Toolpath& toolpath,
                                  const std::vector<CorrectionMap>& maps, const CorrectionWriting& writing,
                                  const std::vector<LaterMap>& trims = {});

}  // namespace lamina
