// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/upload/upload_stop.hpp"

#include "base/duration_text.hpp"

namespace lamina {
namespace {

constexpr double kRepeatHeatersOff = 5.0;  // s
constexpr double kLastLook = 2.0;          // s before a stop is given up; longer than reports are apart

UploadStop::Verdict ask(UploadStep step) { return {step, std::nullopt}; }
UploadStop::Verdict confirmed(const std::string& how) { return {std::nullopt, how}; }

}  // namespace

UploadStop::Verdict UploadStop::judge(const PrintServer& server, const std::string& told, double now) {
  const MachineReport& report = server.report();
  if (report.is_halted && emergency_.is_asked)
    return confirmed(
        "; it was shut down by an emergency stop, its heaters with it, and has lost its position: restart it "
        "and home it");
  if (report.is_halted) {
    const std::string halt = "the printer has shut itself down: " + report.condition;
    return confirmed(told.find(halt) != std::string::npos ? "" : "; " + halt);
  }
  if (!report.is_ready) return {};
  if (report.isPrintUnderWay() && !server.isOurs())
    return confirmed("; the print that is under way now, \"" + report.file + "\", was left alone");
  if (report.isPrintUnderWay()) {
    was_seen_ = true;
    return cancel(report.state, now);
  }
  // The start may still be waiting in the machine: without the file it comes to nothing.
  if (!was_seen_ && !is_removed_) return ask(UploadStep::Remove);
  const std::string how = "; the machine has ended the print";
  if (settings_.keep_heaters_on) return awaitStandstill(report, how, now);
  if (!report.has_targets) return awaitStandstill(report, how + ", and its heaters are off", now);
  if (isEmergencyStopDue()) return ask(UploadStep::EmergencyStop);
  if (heaters_asked_s_ && now < *heaters_asked_s_ + kRepeatHeatersOff) return {};
  return ask(UploadStep::HeatersOff);
}

/// Motions that the machine has already planned are run to their end, which may take longer than the stop.
UploadStop::Verdict UploadStop::awaitStandstill(const MachineReport& report, const std::string& how,
                                                double now) const {
  if (!report.is_moving) return confirmed(how);
  if (now < until_s_ - kLastLook) return {};
  return confirmed(how + "; it was still moving " + wholeSeconds(settings_.safe_stop_timeout_s - kLastLook) +
                   " later: look after it");
}

/// Once in each state in which the print can be, twice where it stays paused: a request that was not answered
/// may still be waiting in the machine for a command to end.
UploadStop::Verdict UploadStop::cancel(PrintState print, double now) {
  if (isEmergencyStopDue()) return ask(UploadStep::EmergencyStop);
  if (print == PrintState::Changing) {
    begin(now);
    return {};
  }
  const bool is_paused = print == PrintState::Paused;
  int& asked = cancels_[is_paused ? 1 : 0];
  if (asked >= (is_paused ? 2 : 1)) return {};
  ++asked;
  return ask(UploadStep::Cancel);
}

void UploadStop::notDone(UploadStep step) {
  if (step == UploadStep::Cancel) cancels_ = {};
  if (step == UploadStep::HeatersOff) heaters_asked_s_.reset();
}

void UploadStop::emergencyStopTaken() {
  emergency_.is_taken = true;
  emergency_.answer = "the server has taken it";
}

bool UploadStop::takeEmergencyStop(const PrintServer& server, double now) {
  const bool is_wanted = settings_.emergency_stop == EmergencyStop::Unconfirmed;
  if (!is_wanted || server.emergencyStop().empty() || emergency_.is_asked) return false;
  emergency_.is_asked = true;
  begin(now);
  return true;
}

std::string UploadStop::remark(const PrintServer& server) const {
  std::string text = "; the machine has not confirmed within " + wholeSeconds(settings_.safe_stop_timeout_s) +
                     " that it has ended the print" +
                     (settings_.keep_heaters_on ? "" : " and turned its heaters off") + ": look after it";
  const std::string emergency = server.emergencyStop();
  if (emergency_.is_asked) {
    text += "; an emergency stop was asked for: " + emergency_.answer;
  } else if (!emergency.empty()) {
    text += "; an emergency stop, by which it loses its position, is not kept waiting: " + emergency;
  }
  return text;
}

}  // namespace lamina
