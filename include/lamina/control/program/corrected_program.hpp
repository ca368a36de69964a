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
  double split_change = 0.02;        ///< a line is split where the amount changes by more
  double place_tolerance_mm = 0.05;  ///< that a program's motions may be off the toolpath
  int decimals = 3;                  ///< of coordinates
  /// Mode of E until M82 or M83 sets it; if empty, absolute.
  std::optional<ExtrusionMode> initial_extrusion;
};

/// What became of a program.
struct CorrectionReport {
  std::size_t corrected_lines = 0;  ///< of depositing motions
  std::size_t added_lines = 0;      ///< by splitting
  std::size_t off_path_lines = 0;   ///< that deposit beside the toolpath: left as they are
  double planned_mm = 0.0;          ///< filament that the corrected lines push
  double corrected_mm = 0.0;        ///< and that they push now
};

/// Writes corrections into G-code, line by line: only increments of E, F and the axis along the layers'
/// normal change, and lines are split, arcs into chords, where the amount changes. A line that no correction
/// changes keeps its bytes, unless E is absolute and has been changed before, or a changed feed or height has
/// to be taken back. The lines come and go one by one, so that a streamer may correct what it has not sent.
class ProgramCorrector {
 public:
  /// @param toolpath  that the program was written from, in coordinates of the program; must outlive this
  /// @param maps      one per layer at most
  /// @throws InvalidInput as `validate`; if a map is of another toolpath, or two are of one layer, or one
  ///   shifts the nozzle by more than its layer's height; if the change at which lines are split is not
  ///   positive
  ProgramCorrector(const Toolpath& toolpath, const std::vector<CorrectionMap>& maps,
                   const CorrectionWriting& writing);
  ~ProgramCorrector();
  ProgramCorrector(const ProgramCorrector&) = delete;
  ProgramCorrector& operator=(const ProgramCorrector&) = delete;

  /// A map that came meanwhile, of a layer of which nothing is read yet.
  /// @throws InvalidInput as the constructor; if the layer has begun
  void add(const CorrectionMap& map);

  /// A later map of a layer, part of which may be read: it takes the place of the one before on lines that
  /// are read from now on.
  /// @throws InvalidInput as the constructor
  void trim(const CorrectionMap& map);

  /// Appends what a line becomes, each line with its line feed but the last.
  /// @param line  without its line feed
  /// @throws InvalidProgram naming the line of what cannot be corrected: G91 or G20 within the part, E that
  ///   firmwares read differently, a checksum, which would not hold
  void read(std::string_view line, std::size_t number, std::string& out);

  const CorrectionReport& report() const;

 private:
  class Writer;
  std::unique_ptr<Writer> writer_;
};

/// A later map of a layer, and where it takes the place of the one before.
struct LaterMap {
  std::size_t from_line = 0;  ///< of the program, from 1
  CorrectionMap map;
};

/// A whole program that is held in memory. With corrections of nothing it is the same to the last byte.
struct CorrectedProgram {
  std::string text;
  CorrectionReport report;
};
/// @param trims  ascending by line; of equal lines the last one holds
/// @throws as `ProgramCorrector`
CorrectedProgram correctedProgram(std::string_view program, const Toolpath& toolpath,
                                  const std::vector<CorrectionMap>& maps, const CorrectionWriting& writing,
                                  const std::vector<LaterMap>& trims = {});

}  // namespace lamina
