// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/control/program/planned_correction.hpp"
#include "lamina/streaming/job/streamable_program.hpp"

namespace lamina {

/// Where the corrections of a program are.
struct CorrectionFiles {
  std::string maps;      ///< file, or folder of files
  std::string toolpath;  ///< that the maps are of; empty for that beside them
};

/// Reads toolpath and maps, and refuses them if they do not belong together.
/// @param program_sha256  of the program that is to be corrected, without corrections
/// @throws FileError, InvalidProgram, InvalidInput as `readProgrammedToolpath`, `readCorrectionFiles` and
///   `requireOfProgram`
PlannedCorrection correctionFrom(const CorrectionFiles& files, const LoopSettings& feeding,
                                 const std::string& program_sha256);

/// A program corrected by files as it is streamed, which says what it was made from. Of the recorded program
/// its lines are those that were sent, as far as the record goes, and as planned from there on.
/// @param correction  from those files
/// @throws as `correctedByMaps`; as `StreamableProgram::fromText` of what is made
StreamableProgram programByMaps(const StreamableProgram& planned, const CorrectionFiles& files,
                                const PlannedCorrection& correction, const StreamSettings& settings);

}  // namespace lamina
