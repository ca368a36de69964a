// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/job/job_failures.hpp"

#include "streaming/job/revised_lines.hpp"

namespace lamina {

std::optional<Failure> shortfall(std::uint64_t lines_read, const JobRecord& record,
                                 const RevisedLines* revised) {
  if (revised != nullptr && revised->failure().code != ErrorCode::Ok)
    return Failure{revised->failure().code, revised->failure().message + record.whereItStands()};
  if (lines_read >= record.status.lines_total) return std::nullopt;
  return Failure{ErrorCode::InvalidProgram,
                 "the program ended after line " + std::to_string(lines_read) + " of " +
                     std::to_string(record.status.lines_total) +
                     " while it was streamed: it was changed, or its disk did not answer"};
}

Failure fallenSilent(const std::string& duration, const JobRecord& record) {
  return {ErrorCode::TimedOut, "no answer from the machine for " + duration + record.whereItStands()};
}

Failure nobodyThere(const std::string& limit) {
  return {ErrorCode::TimedOut,
          "no machine answered within " + limit + "; is it on, and is the baud rate right?"};
}

}  // namespace lamina
