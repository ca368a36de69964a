// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/grbl/grbl_program_check.hpp"

#include "streaming/firmware/grbl/grbl_syntax.hpp"

namespace lamina {

GrblProgramCheck::GrblProgramCheck(const StreamableProgram& program, const GrblMachine& machine)
    : program_(program), machine_(machine), cursor_(program_.open()) {}

void GrblProgramCheck::checkMoreLines() {
  constexpr int kLinesAtOnce = 20000;
  for (int i = 0; i < kLinesAtOnce && !is_done_ && defect_.empty(); ++i) {
    const auto line = cursor_.next();
    is_done_ = !line;
    if (!line) return;
    const std::string defect = defectForGrbl(line->command, machine_);
    if (!defect.empty()) {
      defect_ = here(*line) + " " + defect;
    } else if (machine_.is_laser && warning_.empty() && keepsLaserOn(line->command)) {
      warning_ = here(*line) +
                 " keeps the laser on while the machine stands still, be it that its lines stop coming; with "
                 "M4 it goes off then";
    }
  }
}

std::string GrblProgramCheck::here(const ProgramLine& line) const {
  return program_.name() + " line " + std::to_string(cursor_.textLine()) + ": " +
         program_.quotation().of(line.command);
}

}  // namespace lamina
