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

/// What programs are corrected by before they are run.
struct PlannedCorrection {
  ProgrammedToolpath planned;
  std::vector<FiledMap> maps;  ///< by layer and line, ascending
  LoopSettings feeding;        ///< dead time, lag and limits of the feeder, by which amounts are led
  /// Whether it is the program that the lines of the maps are of; of another one each holds for its layer.
  bool is_recorded_program = false;
};

/// Refuses maps of another program.
/// @throws InvalidInput naming the file of the first that `defectOf` has something against
void requireOfProgram(const PlannedCorrection& correction);

/// The maps as they are written into a program: led for the feeder, and under the id that the toolpath has in
/// coordinates of the program. One for each, in their order.
/// @throws InvalidInput as `ledMap`
std::vector<CorrectionMap> ledMaps(const PlannedCorrection& correction);

/// The settings of a feeder that amounts are led by, as `key=value` with spaces between.
std::string feedingText(const LoopSettings& feeding);

/// Refuses a program that is not of a toolpath. It is read whole, so that what cannot be corrected is refused
/// before any of it runs.
/// @param name  of the program in errors
/// @throws InvalidProgram if none of what it deposits lies on the toolpath; as `ProgramCorrector`
void requireLaysToolpath(const std::string& name, std::istream& program, const Toolpath& toolpath);

/// A whole G-code program with each layer corrected by its map, line for line as the streamer corrects it
/// where the same maps come in time. With maps of nothing it is the same to the last byte.
/// @param name  of the program in errors
/// @throws InvalidInput as `requireOfProgram` and `ledMaps`; if two maps are of one layer, naming the file
/// @throws InvalidProgram as `requireLaysToolpath`
CorrectedProgram correctedByMaps(const std::string& name, const std::string& program,
                                 const PlannedCorrection& correction);

}  // namespace lamina
