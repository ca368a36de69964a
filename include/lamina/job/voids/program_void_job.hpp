// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>

#include "lamina/job/voids/drop_void_job.hpp"
#include "lamina/job/voids/void_filling.hpp"

namespace lamina {

/// A request to fill the voids of a program, be it of beads or of drops.
struct ProgramVoidJob {
  std::string program;  ///< path of a .gcode file
  std::string output;   ///< file to write; empty for none
  /// As `VoidJob::part`; required for beads, not used for drops, whose contours show their inside.
  std::string part;
  JobSettings settings;
};

/// Report on the filling, by the kind of the program.
using ProgramVoidReport = std::variant<VoidFillingReport, DropVoidReport>;

/// Fills the voids of a program and writes it: a program of drops (`isDropProgram`) as by `fillDropProgram`,
/// one of beads as by `runVoidFillingJob`.
/// @throws as these; InvalidInput if a program of beads comes without a part, or output and input are the
///   same file
ProgramVoidReport runProgramVoidJob(const ProgramVoidJob& job, Progress& progress);

}  // namespace lamina
