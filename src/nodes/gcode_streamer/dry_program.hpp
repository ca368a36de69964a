// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/scratch_folder.hpp"
#include "lamina/gcode_rewrite/dry_run.hpp"
#include "lamina/streaming/job/streamable_program.hpp"
#include "messages.hpp"

namespace lamina {

/// A program as it is run dry, in a folder that exists during the object's lifetime.
class DryProgram {
 public:
  /// @throws InvalidConfig, InvalidProgram as `DryRun`; FileError
  DryProgram(const StreamableProgram& asked, const DryRunSettings& settings, const StreamSettings& stream);

  const StreamableProgram& program() const { return program_; }
  const DryRunReport& report() const { return report_; }

 private:
  ScratchFolder folder_;
  DryRunReport report_;
  StreamableProgram program_;
};

/// Whether a goal is run dry.
/// @throws InvalidInput if there is no such dry run, or the goal requests what only jobs with their process
///   allow
bool isDry(const lamina_msgs::StreamProgramGoal& goal);

}  // namespace lamina
