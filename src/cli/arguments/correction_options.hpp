// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "lamina/control/program/planned_correction.hpp"

namespace lamina::cli {

/// Where the corrections of a program are, as it was typed.
struct CorrectionOptions {
  std::string maps;      ///< file, or folder of files
  std::string toolpath;  ///< that the maps are of; empty for that beside them
};

/// Adds `--toolpath`.
void addToolpathOption(CLI::App& subcommand, CorrectionOptions& options);

/// Reads toolpath and maps, and refuses them if they do not belong together.
/// @param program_sha256  of the program that is to be corrected, without corrections
/// @throws FileError, InvalidProgram, InvalidInput as `readProgrammedToolpath`, `readCorrectionFiles` and
///   `requireOfProgram`
PlannedCorrection correctionFrom(const CorrectionOptions& options, const LoopSettings& feeding,
                                 const std::string& program_sha256);

}  // namespace lamina::cli
