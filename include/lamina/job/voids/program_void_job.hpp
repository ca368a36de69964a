// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <variant>

#include "lamina/job/voids/drop_void_job.hpp"
#include "lamina/job/voids/void_filling.hpp"

namespace lamina {

/// One request: fill the voids of a program, whether it lays beads or drops.
struct ProgramVoidJob {
  std::string program;  ///< path of a .gcode file
  std::string output;   ///< file to write; empty for none
  std::string part;     ///< as `VoidJob::part`; programs of drops show their inside by their contours
  JobSettings settings;
};

/// What filling did, by the kind of the program.
using ProgramVoidReport = std::variant<VoidFillingReport, DropVoidReport>;

/// Fills the voids of a program of drops (`isDropProgram`) as `fillDropProgram`, those of another as
/// `runVoidFillingJob`, and writes it.
/// @throws as these; InvalidInput if a program of beads comes without a part, or output and input are the
/// same file
ProgramVoidReport runProgramVoidJob(const ProgramVoidJob& job, Progress& progress);

}  // namespace lamina
