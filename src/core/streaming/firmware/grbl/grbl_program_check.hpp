// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/streaming/job/streamable_program.hpp"
#include "streaming/firmware/grbl/grbl_machine.hpp"

namespace lamina {

/// Checks a program against the abilities of a machine: unknown commands are named before anything moves. The
/// check is done in pieces, as programs are long.
class GrblProgramCheck {
 public:
  /// @throws FileError if the program is gone
  GrblProgramCheck(const StreamableProgram& program, const GrblMachine& machine);

  /// Checks some more lines, up to the first that the machine does not accept.
  void checkMoreLines();

  /// Whether all lines were checked.
  bool isDone() const { return is_done_; }
  /// The line that the machine does not accept, and why; empty if there is none so far.
  const std::string& defect() const { return defect_; }
  /// The first line about which the user should know, and why; empty if there is none so far.
  const std::string& warning() const { return warning_; }

 private:
  std::string here(const ProgramLine& line) const;

  StreamableProgram program_;
  GrblMachine machine_;
  ProgramCursor cursor_;
  bool is_done_ = false;
  std::string defect_;
  std::string warning_;
};

}  // namespace lamina
