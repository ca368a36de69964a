// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/control/program/planned_correction.hpp"
#include "lamina/streaming/job/streamable_program.hpp"

namespace lamina {

/// Files from which the corrections of a program are read.
struct CorrectionFiles {
  std::string maps;  ///< correction maps: a file, or a folder of files
  /// Toolpath to which the maps belong; empty for the toolpath in the folder of the maps.
  std::string toolpath;
};

/// Reads toolpath and maps.
/// @param program_sha256  hash of the program that is to be corrected, without corrections
/// @throws FileError, InvalidProgram, InvalidInput as `readProgrammedToolpath` and `readCorrectionFiles`; as
///   `requireOfProgram` if toolpath and maps do not belong together
PlannedCorrection correctionFrom(const CorrectionFiles& files, const LoopSettings& feeding,
                                 const std::string& program_sha256);

/// The program as corrected by the maps while it is streamed; it states its origin (`ProgramOrigin`). The
/// program of a recorded job has the lines that were sent, as far as the record goes, followed by the planned
/// lines.
/// @param correction  as `correctionFrom` reads it from `files`
/// @throws as `correctedByMaps`; as `StreamableProgram::fromText` of the corrected program
StreamableProgram programByMaps(const StreamableProgram& planned, const CorrectionFiles& files,
                                const PlannedCorrection& correction, const StreamSettings& settings);

}  // namespace lamina
