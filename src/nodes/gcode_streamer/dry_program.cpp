// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dry_program.hpp"

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {

DryProgram::DryProgram(const StreamableProgram& asked, const DryRunSettings& settings,
                       const StreamSettings& stream)
    : report_(writeDryRun(*asked.openText(), folder_.path() + "/dry.gcode", settings)),
      program_(StreamableProgram::fromFile(folder_.path() + "/dry.gcode", stream)) {}

bool isDry(const lamina_msgs::StreamProgramGoal& goal) {
  if (goal.dry.empty() && goal.speed == 0.0) return false;
  if (goal.dry.empty())
    throw InvalidInput("speed is " + numberText(goal.speed) +
                       ", of a job with its process; expected 0, or a dry run (change_job changes the feed)");
  if (goal.dry != "air")
    throw InvalidInput("dry is '" + goal.dry + "'; expected air, or nothing for a job with its process");
  if (goal.resume || !goal.execution.empty())
    throw InvalidInput("a dry run keeps no progress file; expected it without resume and execution");
  return true;
}

}  // namespace lamina
