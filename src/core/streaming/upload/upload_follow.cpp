// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>

#include "base/duration_text.hpp"
#include "streaming/upload/upload_job.hpp"

namespace lamina {
namespace {

constexpr double kRepeatCommand = 5.0;  // s
constexpr double kLastLook = 2.0;       // s before a stop is given up; longer than reports are apart

std::string named(const MachineReport& report) { return "\"" + report.file + "\""; }

}  // namespace

void UploadJob::onReport(double now) {
  heard_at_ = now;
  takeTelemetry();
  takeComplaints();
  countStalls();
  switch (phase_) {
    case Phase::Check:
      return check(now);
    case Phase::Follow:
      return was_seen_ ? follow(now) : awaitStart(now);
    case Phase::Finish:
      return finish(now);
    case Phase::Stop:
      return stop(now);
    default:
      return;
  }
}

void UploadJob::takeTelemetry() {
  const MachineReport& report = server().report();
  StreamStatus& status = record_.status;
  if (report.temperatures) status.temperatures = report.temperatures;
  if (report.position) status.position = report.position;
  if (!may_be_started_ || !server().isOurs() || report.state == PrintState::None) return;
  status.lines_acknowledged = std::max(status.lines_acknowledged, read_line_.linesBefore(report.bytes_read));
  status.layer = read_line_.layer();
}

/// As a link does that hears them: counted, and the first one quoted.
void UploadJob::takeComplaints() {
  for (const std::string& complaint : server().takeComplaints()) {
    if (!may_be_started_) continue;
    StreamStatus& status = record_.status;
    status.message = complaint;
    if (++status.commands_not_done == 1) status.first_not_done = complaint;
  }
}

void UploadJob::countStalls() {
  const auto& stalls = server().report().stalls;
  if (!stalls) return;
  Starvation& starvation = record_.status.starvation;
  starvation.source = StarvationSource::Machine;
  // A machine that was restarted counts anew.
  if (!may_be_started_ || !stalls_before_) stalls_before_ = *stalls;
  if (*stalls > *stalls_before_) starvation.count = *stalls - *stalls_before_;
}

void UploadJob::check(double now) {
  const MachineReport& report = server().report();
  if (order_->start == JobStart::Resume) return recognise(now);
  if (!report.is_ready)
    return abort({ErrorCode::Rejected, "the printer is not ready: " + report.condition}, now);
  if (report.isPrintUnderWay()) {
    return abort({ErrorCode::Rejected,
                  "the printer has another print under way, " + named(report) + "; expected it to have none"},
                 now);
  }
  if (report.is_moving) return awaitIdleness(now);
  busy_since_.reset();
  phase_ = is_stored_ ? Phase::Start : Phase::Upload;
  next_at_ = now;
}

/// A print that was begun earlier is known by the name of its file, and then by its bytes; meanwhile it may
/// have ended.
void UploadJob::recognise(double now) {
  const MachineReport& report = server().report();
  const bool is_known = report.state != PrintState::None &&
                        report.file.compare(0, order_->earlier_files.size(), order_->earlier_files) == 0;
  if (!is_known) {
    const std::string last =
        report.file.empty() ? "it knows of no print" : "its last print is " + named(report);
    return abort(
        {ErrorCode::Rejected, "there is no print of this program to go on with: " + last + "; expected " +
                                  order_->earlier_files +
                                  "... (a machine that was restarted has lost it, and its position)"},
        now);
  }
  // What has ended leaves the machine to others, who may have heated it since.
  constexpr const char* kLeftAlone = "; its heaters and its file were left as they are";
  if (report.state == PrintState::Stopped)
    return abort({ErrorCode::Cancelled, std::string("the print was cancelled at the machine") + kLeftAlone},
                 now);
  if (report.state == PrintState::Failed)
    return abort({ErrorCode::Rejected, "the print has ended with an error: " + report.condition + kLeftAlone},
                 now);
  if (is_stored_ && server().isOurs()) return adopt(now);
  server().follow(report.file);
  phase_ = Phase::Verify;
  next_at_ = now;
}

/// Nothing is started or stopped: the print is followed from where it is. One that is complete is no longer
/// there to be stopped.
void UploadJob::adopt(double now) {
  may_be_started_ = may_be_stored_ = was_seen_ = true;
  was_complete_ = !server().report().isPrintUnderWay();
  record_.status.lines_sent = record_.status.lines_total;
  record_.enter(PackmlState::Execute);
  phase_ = Phase::Follow;
  heard_at_ = now;
}

/// A print that is asked for while another's command is under way, such as to wait for heat, would begin when
/// that has ended, whenever this is.
void UploadJob::awaitIdleness(double now) {
  if (!busy_since_) busy_since_ = now;
  if (now < *busy_since_ + settings_.connect_timeout_s) return;
  abort({ErrorCode::Rejected, "the printer has been busy for " + wholeSeconds(now - *busy_since_) +
                                  " with motions or commands of somebody else; expected it to stand still"},
        now);
}

void UploadJob::awaitStart(double now) {
  const MachineReport& report = server().report();
  if (server().isOurs() && report.state != PrintState::None) {
    was_seen_ = true;
    record_.enter(PackmlState::Execute);
    return follow(now);
  }
  if (report.is_halted) {
    abort({ErrorCode::DeviceError, "the printer has shut itself down: " + report.condition}, now);
  } else if (report.isPrintUnderWay()) {
    abort({ErrorCode::Rejected, "another print, " + named(report) + ", was started before this one"}, now);
  } else if (now >= started_at_ + settings_.connect_timeout_s) {
    abort({ErrorCode::TimedOut,
           "the machine has not begun the print within " + wholeSeconds(settings_.connect_timeout_s)},
          now);
  }
}

void UploadJob::follow(double now) {
  const MachineReport& report = server().report();
  if (report.is_halted)
    return abort({ErrorCode::DeviceError, "the printer has shut itself down: " + report.condition}, now);
  if (!server().isOurs()) {
    if (!report.file.empty())
      return abort({ErrorCode::Cancelled, "another print, " + named(report) + ", was started at the machine"},
                   now);
    return abort({ErrorCode::DeviceError,
                  "the machine no longer knows of the print: it was restarted, or the print was cleared"},
                 now);
  }
  switch (report.state) {
    case PrintState::None:
      return abort({ErrorCode::DeviceError, "the machine no longer knows how the print stands"}, now);
    case PrintState::Stopped:
      return abort({ErrorCode::Cancelled, "the print was cancelled at the machine"}, now);
    case PrintState::Failed:
      return abort({ErrorCode::Rejected, "the print has ended with an error: " + report.condition}, now);
    case PrintState::Complete:
      complete();
      completed_at_ = now;
      return;
    default:
      followHold(now);
      return pauseAtLayer(now);
  }
}

void UploadJob::pauseAtLayer(double now) {
  if (record_.status.state != PackmlState::Execute || !layer_pause_.takeIfDueAt(record_.status.layer)) return;
  record_.status.message = "held in layer " + std::to_string(record_.status.layer);
  pause(now);
}

/// Holding and going on, whoever asked for it.
void UploadJob::followHold(double now) {
  const PrintState print = server().report().state;
  const bool is_to_repeat = now >= asked_at_ + kRepeatCommand && !command_;
  switch (record_.status.state) {
    case PackmlState::Execute:
      if (print != PrintState::Paused) return;
      record_.status.message = "paused at the machine";
      record_.enter(PackmlState::Holding);
      record_.enter(PackmlState::Held);
      return;
    case PackmlState::Holding:
      if (print == PrintState::Paused) {
        record_.enter(PackmlState::Held);
        if (is_to_resume_) resume(now);
      } else if (print == PrintState::Printing && is_to_repeat) {
        command_ = UploadStep::Pause;
      }
      return;
    case PackmlState::Held:
      if (print != PrintState::Printing) return;
      record_.status.message = "resumed at the machine";
      record_.enter(PackmlState::Unholding);
      record_.enter(PackmlState::Execute);
      return;
    case PackmlState::Unholding:
      if (print == PrintState::Printing) record_.enter(PackmlState::Execute);
      if (print == PrintState::Paused && is_to_repeat) command_ = UploadStep::Resume;
      return;
    default:
      return;
  }
}

/// The machine has said that this print is complete. A hold that came too late for it has no effect.
void UploadJob::complete() {
  if (record_.status.state == PackmlState::Holding) record_.enter(PackmlState::Held);
  if (record_.status.state == PackmlState::Held) record_.enter(PackmlState::Unholding);
  if (record_.status.state == PackmlState::Unholding) record_.enter(PackmlState::Execute);
  record_.enter(PackmlState::Completing);
  command_.reset();
  phase_ = Phase::Finish;
}

/// It has to say so twice: a Duet's computer may learn that a print has ended before it learns how. Klipper
/// calls a print complete when its last line was read, and may shut down in the motions that are still to
/// come.
void UploadJob::finish(double now) {
  const MachineReport& report = server().report();
  if (report.is_halted || !server().isOurs() || report.state != PrintState::Complete) return follow(now);
  if (report.is_moving) {
    if (now < completed_at_ + settings_.blocking_timeout_s) return;
    return abort({ErrorCode::TimedOut, "the machine has reported the print complete, and was still moving " +
                                           wholeSeconds(settings_.blocking_timeout_s) + " later"},
                 now);
  }
  record_.status.lines_acknowledged = record_.status.lines_total;
  phase_ = Phase::Remove;
  next_at_ = now;
}

// The safe stop

void UploadJob::stop(double now) {
  const MachineReport& report = server().report();
  if (report.is_halted) {
    if (emergency_.is_asked) {
      return confirmStop(
          "; it was shut down by an emergency stop, its heaters with it, and has lost its "
          "position: restart it and home it");
    }
    const std::string halt = "the printer has shut itself down: " + report.condition;
    const bool is_told = record_.status.failure.message.find(halt) != std::string::npos;
    return confirmStop(is_told ? "" : "; " + halt);
  }
  if (!report.is_ready) return;
  if (report.isPrintUnderWay()) {
    was_seen_ = was_seen_ || server().isOurs();
    if (server().isOurs()) return askToCancel(now);
    return confirmStop("; the print that is under way now, " + named(report) + ", was left alone");
  }
  if (!was_seen_ && !is_removed_) {
    // The start may still be waiting in the machine: without the file it comes to nothing.
    command_ = UploadStep::Remove;
    next_at_ = now;
    return;
  }
  if (settings_.keep_heaters_on) return awaitStandstill("; the machine has ended the print", now);
  if (!report.has_targets)
    return awaitStandstill("; the machine has ended the print, and its heaters are off", now);
  if (isEmergencyStopDue()) {
    command_ = UploadStep::EmergencyStop;
  } else if (!asked_heaters_off_ || now >= asked_at_ + kRepeatCommand) {
    command_ = UploadStep::HeatersOff;
    next_at_ = now;
  }
}

/// Motions that the machine has already planned are run to their end, which may take longer than the stop.
void UploadJob::awaitStandstill(const std::string& how, double now) {
  if (!server().report().is_moving) return confirmStop(how);
  if (now >= stop_until_ - kLastLook)
    confirmStop(how + "; it was still moving " + wholeSeconds(settings_.safe_stop_timeout_s - kLastLook) +
                " later: look after it");
}

/// Once in each state in which the print can be, twice where it stays paused: a request that was not answered
/// may still be waiting in the machine for a command to end.
void UploadJob::askToCancel(double now) {
  const PrintState print = server().report().state;
  if (isEmergencyStopDue()) {
    command_ = UploadStep::EmergencyStop;
    return;
  }
  if (print == PrintState::Changing) {
    stop_until_ = now + settings_.safe_stop_timeout_s;
    return;
  }
  const bool is_paused = print == PrintState::Paused;
  int& asked = cancels_[is_paused ? 1 : 0];
  if (asked >= (is_paused ? 2 : 1)) return;
  ++asked;
  command_ = UploadStep::Cancel;
  next_at_ = now;
}

void UploadJob::confirmStop(const std::string& how) {
  record_.status.failure.message += how;
  phase_ = is_removed_ ? Phase::Leave : Phase::Remove;
  next_at_ = heard_at_;
}

void UploadJob::giveUpStop(double now) {
  if (under_way_) is_to_break_ = true;
  under_way_.reset();
  const std::string emergency = server().emergencyStop();
  if (settings_.emergency_stop == EmergencyStop::Unconfirmed && !emergency.empty() && !emergency_.is_asked) {
    emergency_.is_asked = true;
    command_ = UploadStep::EmergencyStop;
    next_at_ = now;
    stop_until_ = now + settings_.safe_stop_timeout_s;
    return;
  }
  record_.status.failure.message +=
      "; the machine has not confirmed within " + wholeSeconds(settings_.safe_stop_timeout_s) +
      " that it has ended the print" + (settings_.keep_heaters_on ? "" : " and turned its heaters off") +
      ": look after it";
  if (emergency_.is_asked) {
    record_.status.failure.message += "; an emergency stop was asked for: " + emergency_.answer;
  } else if (!emergency.empty()) {
    record_.status.failure.message +=
        "; an emergency stop, by which it loses its position, is not kept waiting: " + emergency;
  }
  close();
}

}  // namespace lamina
