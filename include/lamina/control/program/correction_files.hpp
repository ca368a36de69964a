// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lamina/control/correction_map.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A toolpath as a program for a machine has it.
struct ProgrammedToolpath {
  std::string id;     ///< of the toolpath as it was planned, which correction maps name
  Toolpath toolpath;  ///< in coordinates of the program
};

/// File beside correction maps that holds the toolpath they are of.
inline constexpr char kProgrammedToolpathFile[] = "toolpath.csv";
/// File beside correction maps that says which of them were applied.
inline constexpr char kAppliedMapsFile[] = "record.csv";

/// The toolpath as CSV under a line that states its id. Layers and paths keep their numbers, and numbers read
/// back to the same double.
std::string programmedToolpathCsv(const ProgrammedToolpath& planned);

/// @param source  names the text in errors
/// @throws InvalidProgram as `readCsv`; if the first line states no id
ProgrammedToolpath readProgrammedToolpath(std::string_view text, const std::string& source);

/// A map and the file that it was read from.
struct FiledMap {
  std::string file;
  CorrectionMap map;
};

/// The maps of a file, or of a folder as `lamina estimate` and the streamer write them:
/// `correction_<layer>.csv` and `layer_<layer>.csv`. Where the folder has a record of what was applied, it
/// says which of them count. By layer, ascending.
/// @throws FileError if there is nothing to read
/// @throws InvalidInput naming the file: as `readCorrectionMap`; if two maps are of one layer, a folder has
///   none, or a map that was applied is missing or has another digest than the record says
std::vector<FiledMap> readCorrectionFiles(const std::string& path);

/// Why a map cannot be of a program, as the rest of a sentence that begins with its name; empty if it can:
/// another toolpath, a layer or path that there is not, a shift of more than the layer's height.
std::string defectOf(const CorrectionMap& map, const ProgrammedToolpath& planned);

}  // namespace lamina
