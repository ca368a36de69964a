// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "lamina/program/gcode/laid_filament.hpp"
#include "lamina/streaming/job/program_revision.hpp"

namespace lamina {

/// How much of a job is laid by the lines that its machine has accepted: of the lines as they are sent, those
/// of a revision included.
class LaidLines {
 public:
  /// @param revision  changes the lines before they are sent; null if they are sent unchanged
  /// @param filament_diameter_mm  of programs that state none
  /// @throws FileError if the program's file is gone
  LaidLines(const StreamableProgram& program, const std::shared_ptr<ProgramRevision>& revision,
            double filament_diameter_mm);

  /// The revision that is to be given to the session in the place of the other one, whose lines this counts;
  /// null without a revision.
  std::shared_ptr<ProgramRevision> revision() const;

  /// What is laid once that many lines are accepted. Lines are read on from the last call, at most so many in
  /// this one; fewer of them change nothing. A line after which nothing is known is logged.
  const LaidFilament& through(std::uint64_t lines,
                              std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

 private:
  class Counted;

  std::optional<std::string> nextCommand();

  std::shared_ptr<Counted> revision_;
  std::optional<ProgramCursor> program_;  ///< without a revision
  LaidFilament laid_;
  std::uint64_t lines_ = 0;
  bool is_fault_logged_ = false;
};

}  // namespace lamina
