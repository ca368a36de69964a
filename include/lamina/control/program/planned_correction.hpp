// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "lamina/control/loop_settings.hpp"
#include "lamina/control/program/corrected_program.hpp"
#include "lamina/control/program/correction_files.hpp"

namespace lamina {

/// The corrections of a program that are known before it is run.
struct PlannedCorrection {
  ProgrammedToolpath planned;
  std::vector<FiledMap> maps;  ///< by layer and line, ascending
  LoopSettings feeding;        ///< dead time, lag and limits of the feeder, for leading amounts
  /// Whether the lines in `maps` are those of this program. Otherwise each map holds for its whole layer.
  bool is_recorded_program = false;
};

/// Refuses maps that cannot belong to the program.
/// @throws InvalidInput naming the file of the first one with a defect (`defectOf`)
void requireOfProgram(const PlannedCorrection& correction);

/// The maps as they are written into a program, in the same order: led for the feeder, with the id of the
/// toolpath in coordinates of the program.
/// @throws InvalidInput as `ledMap`
std::vector<CorrectionMap> ledMaps(const PlannedCorrection& correction);

/// The settings by which amounts are led, as `key=value` separated by spaces.
std::string feedingText(const LoopSettings& feeding);

/// Refuses a program that does not lay a toolpath. It reads the whole program, so that lines that cannot be
/// corrected are refused before any of them runs.
/// @param name  of the program in errors
/// @throws InvalidProgram if none of what it deposits lies on the toolpath; as `ProgramCorrector`
void requireLaysToolpath(const std::string& name, std::istream& program, const Toolpath& toolpath);

/// Corrects each layer of a G-code program by its map. The lines are those that the streamer sends if the
/// same maps arrive in time. Maps without corrections give the same bytes.
/// @param name  of the program in errors
/// @throws InvalidInput as `requireOfProgram` and `ledMaps`; if two maps are of one layer, naming the file
/// @throws InvalidProgram as `requireLaysToolpath`
CorrectedProgram correctedByMaps(const std::string& name, const std::string& program,
                                 const PlannedCorrection& correction);

}  // namespace lamina
