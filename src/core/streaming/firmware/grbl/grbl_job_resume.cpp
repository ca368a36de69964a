// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// A job that goes on where an earlier session left it.
#include "streaming/firmware/grbl/grbl_job.hpp"

namespace lamina {
namespace {

constexpr double kPlacePoll = 0.1;  // s; the work's offset is in one of thirty reports
// Behind the head of a line that was cut off it is a word without number, for which grbl refuses the whole.
constexpr const char* kRefusedWord = "Z\n";
constexpr double kMillimetresPerReportedInch = 25.4;

}  // namespace

void GrblJob::refuseCutLine() { output_ += kRefusedWord; }

void GrblJob::beginLocating(double now) {
  phase_ = Phase::Locating;
  // grbl reports Idle in a dwell too: what was reported before its questions were answered is where it stood
  // between two lines.
  work_.reset();
  heard_s_ = now;
  next_poll_s_ = now;
  locate_by_s_ = now + order_.settings.connect_timeout_s;
  goOn(now);
}

/// Once the machine is idle, and has reported where it is in the coordinates of the work.
void GrblJob::goOn(double now) {
  const bool is_idle = machine_state_ == GrblState::Idle;
  if (work_ && is_idle) return goOnAt(*work_, now);
  if (now < locate_by_s_) {
    next_poll_s_ = now + kPlacePoll;
    output_ += grbl_byte::kStatus;
  } else if (work_) {
    abort({ErrorCode::Rejected, "the machine has answered its questions, and was not idle within " +
                                    std::to_string(static_cast<int>(order_.settings.connect_timeout_s)) +
                                    " s, for somebody else; expected Idle"},
          now);
  } else {
    abort(
        {ErrorCode::TimedOut, "the machine does not report where it is in the coordinates of the work (WCO)"},
        now);
  }
}

void GrblJob::goOnAt(GrblAxes work, double now) {
  const GrblMachine& machine = start_.machine();
  for (double& axis : work)
    axis *= machine.reports_in_inches.value_or(false) ? kMillimetresPerReportedInch : 1.0;
  const auto passed = [this](const ProgramLine& line) { record_.status.layer = line.layer; };
  try {
    const GrblResumption found = resumptionOf(order_.program, *order_.unfinished, machine.modes, work);
    if (!found.refusal.empty()) return abort({ErrorCode::Rejected, found.refusal}, now);
    expected_ = found.expected;
    record_.status.lines_acknowledged = record_.status.lines_sent = found.line;
    feed_ = LineFeed(restOf(order_.program, found.line, passed), found.line + 1, record_.status.layer);
  } catch (const Error&) {
    return abort(currentFailure(), now);
  }
  execute(now);
}

}  // namespace lamina
