// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/resume/resume_point.hpp"

#include "lamina/base/error.hpp"
#include "streaming/job/decimal.hpp"
#include "streaming/resume/program_state.hpp"

namespace lamina {

ResumePoint resumePointAfter(const StreamableProgram& program, std::uint64_t taken_through) {
  if (taken_through >= program.lines())
    throw InvalidInput("all " + std::to_string(program.lines()) + " lines of " + program.name() +
                       " were taken: there is nothing to go on with");
  ProgramCursor cursor = program.open();
  ProgramState state;
  ResumePoint point;
  std::int32_t layer = -1;
  for (point.line = 1;; ++point.line) {
    const auto line = cursor.next();
    if (!line) throw InvalidProgram(program.name() + " was changed while it was read");
    if (line->layer != layer) {
      layer = line->layer;
      point.layer_line = point.line;
    }
    if (point.line > taken_through) break;
    state.run(line->command);
  }
  if (layer >= 0) point.layer = layer;
  point.height_mm = state.position.z() - state.shift.z();
  return point;
}

std::string adviceFor(const ResumePoint& point) {
  std::string text =
      "Check on the part where the last bead ends. By what is known, lamina resume could go on from:\n";
  text += "--from-line " + std::to_string(point.line) + "  the first line that was not certainly taken\n";
  if (point.layer)
    text += "--from-layer " + std::to_string(*point.layer) + "  which begins at line " +
            std::to_string(point.layer_line) + "\n";
  return text + "--from-height " + decimal(point.height_mm) + "  where that line begins [mm]\n";
}

}  // namespace lamina
