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
  std::vector<FiledMap> maps;  ///< ascending by layer and line
  LoopSettings feeding;        ///< dead time, lag and limits of the feeder, for leading amounts
  /// Whether the program is the one whose lines the maps state. If not, each map is valid for its whole
  /// layer.
  bool is_recorded_program = false;
};

/// Checks that the maps can belong to the program.
/// @throws InvalidInput naming the file of the first map with a defect (`defectOf`)
void requireOfProgram(const PlannedCorrection& correction);

/// The maps as they are written into a program, in the same order. Their amounts are led for the feeder, and
/// they name the toolpath by its id in coordinates of the program.
/// @throws InvalidInput as `ledMap`
std::vector<CorrectionMap> ledMaps(const PlannedCorrection& correction);

/// The settings by which amounts are led, as `key=value`, separated by spaces.
std::string feedingText(const LoopSettings& feeding);

/// Checks that a program deposits on a toolpath. It reads the whole program, so that lines that cannot be
/// corrected are refused before any of them is run.
/// @param name  name of the program, for errors
/// @throws InvalidProgram if the program deposits nothing on the toolpath; as `ProgramCorrector`
void requireLaysToolpath(const std::string& name, std::istream& program, const Toolpath& toolpath);

/// Corrects each layer of a G-code program by its map. The result is what the streamer sends if the same maps
/// reach it in time. Without corrections in the maps the text stays the same to the byte.
/// @param name  name of the program, for errors
/// @throws InvalidInput as `requireOfProgram` and `ledMaps`; naming the file, if two maps are of one layer
/// @throws InvalidProgram as `requireLaysToolpath`
CorrectedProgram correctedByMaps(const std::string& name, const std::string& program,
                                 const PlannedCorrection& correction);

}  // namespace lamina
