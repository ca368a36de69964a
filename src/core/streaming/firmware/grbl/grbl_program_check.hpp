// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "lamina/streaming/job/streamable_program.hpp"
#include "streaming/firmware/grbl/grbl_machine.hpp"

namespace lamina {

/// The check of a program against a machine, so that what it does not know is named before anything moves. By
/// pieces, since programs are long.
class GrblProgramCheck {
 public:
  /// @throws FileError if the program is gone
  GrblProgramCheck(const StreamableProgram& program, const GrblMachine& machine);

  /// Checks the next lines, up to the first that the machine does not take.
  void goOn();

  /// Whether all lines were checked.
  bool isDone() const { return is_done_; }
  /// The line that the machine does not take, and why; empty if there is none so far.
  const std::string& defect() const { return defect_; }
  /// The first line of which a person should know, and why; empty if there is none so far.
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
