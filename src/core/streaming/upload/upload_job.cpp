// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/upload/upload_job.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/duration_text.hpp"
#include "lamina/streaming/job/unstopped_machine.hpp"
#include "streaming/upload/print_verdict.hpp"

namespace lamina {
namespace {

constexpr double kReportInterval = 1.0;  // s; below the 8 s in which a Duet forgets a session
constexpr double kNearInterval = 0.2;    // s, in front of a layer in which it is to hold
constexpr double kRetryInterval = 2.0;   // s; Moonraker's temporary files are named by the second
constexpr double kRepeatCommand = 5.0;   // s
constexpr int kAttempts = 3;

}  // namespace

UploadJob::UploadJob(const StreamSettings& settings, std::shared_ptr<const UploadOrder> order)
    : settings_(settings),
      order_(std::move(order)),
      servers_(printServers(settings.firmware, order_)),
      account_(record_.status, order_->body),
      stop_(settings) {}

void UploadJob::start(double now) {
  if (record_.status.state != PackmlState::Idle) return;
  record_.enter(PackmlState::Starting);
  next_at_ = heard_at_ = now;
}

// Asking

UploadStep UploadJob::nextStep() const {
  if (is_logged_out_) return UploadStep::Connect;
  switch (phase_) {
    case Phase::Connect:
      return UploadStep::Connect;
    case Phase::Upload:
      return UploadStep::Upload;
    case Phase::Verify:
      return UploadStep::Verify;
    case Phase::Start:
      return UploadStep::Start;
    case Phase::Remove:
      return UploadStep::Remove;
    case Phase::Leave:
      return UploadStep::Disconnect;
    default:
      break;
  }
  if (command_) return *command_;
  return isChangeNext() ? UploadStep::Change : UploadStep::Report;
}

/// Klipper that waits for heat answers no change, but each report: without these it would count as out of
/// reach.
bool UploadJob::isChangeNext() const {
  return phase_ == Phase::Follow && !changes_.empty() && !is_report_due_;
}

std::optional<HttpRequest> UploadJob::takeRequest(double now) {
  while (!under_way_ && phase_ != Phase::Over && record_.status.state != PackmlState::Idle &&
         now >= next_at_) {
    const UploadStep step = nextStep();
    beforeAsking(step, now);
    if (step != nextStep()) continue;
    auto request = server().request(step);
    if (!request) {
      onDone(step, now);
      continue;
    }
    under_way_ = step;
    if (step == UploadStep::Change) is_report_due_ = true;
    return request;
  }
  return std::nullopt;
}

void UploadJob::beforeAsking(UploadStep step, double now) {
  if (step == UploadStep::Upload) {
    if (order_->body.program().hasChanged()) {
      abort({ErrorCode::InvalidProgram,
             order_->body.program().name() + " was changed after it was checked; it was not uploaded"},
            now);
      return;
    }
    may_be_stored_ = true;
  } else if (step == UploadStep::Start) {
    may_be_started_ = true;
    started_at_ = now;
  } else if (step == UploadStep::HeatersOff) {
    stop_.heatersAsked(now);
  } else if (step == UploadStep::Change) {
    server().give(changes_.front());
  } else if (step == UploadStep::Pause || step == UploadStep::Resume) {
    asked_at_ = now;
  }
}

void UploadJob::sent(std::uint64_t bytes) {
  if (under_way_ == UploadStep::Upload) account_.sent(bytes);
}

// Answers

void UploadJob::receive(const HttpResponse& response, double now) {
  if (!under_way_) return;
  const UploadStep step = *std::exchange(under_way_, std::nullopt);
  const ServerAnswer answer = server().read(step, response);
  switch (answer.kind) {
    case AnswerKind::Done:
      if (step != UploadStep::Connect) attempts_ = 0;
      return onDone(step, now);
    case AnswerKind::More:
      next_at_ = now;
      return;
    case AnswerKind::Later:
      return onTrouble(step, answer.failure, Arrival::Possible, now);
    case AnswerKind::NotTaken:
      return onTrouble(step, answer.failure, Arrival::NotTaken, now);
    case AnswerKind::LoggedOut:
      is_logged_out_ = true;
      return onTrouble(step, {ErrorCode::DeviceError, "the machine has ended the session"}, Arrival::Never,
                       now);
    case AnswerKind::NotMine:
      return tryNextServer(now);
    case AnswerKind::Refused:
      return onRefused(step, answer.failure, now);
  }
}

void UploadJob::fail(const HttpFailure& failure, double now) {
  if (!under_way_) return;
  const UploadStep step = *std::exchange(under_way_, std::nullopt);
  onTrouble(step, {ErrorCode::Disconnected, failure.why},
            failure.reached_server ? Arrival::Possible : Arrival::Never, now);
}

void UploadJob::tryNextServer(double now) {
  if (phase_ != Phase::Connect) {
    return onTrouble(UploadStep::Connect, {ErrorCode::DeviceError, "another server answers now"},
                     Arrival::Possible, now);
  }
  attempts_ = 0;
  if (servers_.size() > 1) {
    servers_.erase(servers_.begin());
    next_at_ = now;
    return;
  }
  std::string expected = "Moonraker (Klipper) or a Duet (RepRapFirmware)";
  if (settings_.firmware == "klipper") expected = "Moonraker (Klipper)";
  if (settings_.firmware == "reprapfirmware") expected = "a Duet (RepRapFirmware)";
  abort({ErrorCode::Rejected,
         "the server that answers is no print server that is known here; expected " + expected},
        now);
}

void UploadJob::onDone(UploadStep step, double now) {
  next_at_ = now;
  switch (step) {
    case UploadStep::Connect:
      record_.status.firmware_name = server().name();
      if (std::exchange(is_logged_out_, false)) return;
      attempts_ = 0;
      phase_ = Phase::Check;
      return;
    case UploadStep::Report:
      next_at_ = now + (layer_pause_.isNear(record_.status.layer) ? kNearInterval : kReportInterval);
      is_report_due_ = false;
      onReport(now);
      if (command_ || isChangeNext()) next_at_ = now;
      return;
    case UploadStep::Upload:
      record_.status.lines_sent = record_.status.lines_total;
      phase_ = Phase::Verify;
      return;
    case UploadStep::Verify:
      is_stored_ = true;
      phase_ = Phase::Check;
      return;
    case UploadStep::Start:
      phase_ = Phase::Follow;
      // The request may have waited for the progress file before it was sent.
      heard_at_ = started_at_ = now;
      return;
    case UploadStep::Remove:
      return onRemoved();
    case UploadStep::Disconnect:
      return close();
    case UploadStep::Change:
      changes_.pop_front();
      return;
    case UploadStep::EmergencyStop:
      stop_.emergencyStopTaken();
      command_.reset();
      return;
    default:
      command_.reset();
      return;
  }
}

void UploadJob::onRemoved() {
  command_.reset();
  stop_.removed();
  if (phase_ == Phase::Remove) phase_ = Phase::Leave;
}

void UploadJob::onTrouble(UploadStep step, const Failure& why, Arrival arrival, double now) {
  next_at_ = now + kRetryInterval;
  command_.reset();
  trouble_ = why.message;
  switch (phase_) {
    case Phase::Follow:
    case Phase::Finish:
      return onTroubleInPrint(step, why, arrival, now);
    case Phase::Stop:
      return onTroubleInStop(step, why, arrival);
    case Phase::Remove:
    case Phase::Leave:
      return close();
    case Phase::Start:
      if (arrival != Arrival::Never && step == UploadStep::Start) {
        // It may print all the same: the machine is asked.
        phase_ = Phase::Follow;
        heard_at_ = started_at_ = now;
        return;
      }
      may_be_started_ = false;
      break;
    default:
      break;
  }
  if (++attempts_ >= kAttempts) abort(why, now);
}

void UploadJob::onTroubleInPrint(UploadStep step, const Failure& why, Arrival arrival, double now) {
  if (step == UploadStep::Change && arrival == Arrival::Possible) {
    // It is not repeated: a babystep would be made twice.
    onChangeFailed(why.message + "; it was not asked for again, for it may still be done");
  } else if (step == UploadStep::Change) {
    record_.status.message = changes_.front() + ": " + why.message + "; it is asked for again";
  }
  // Commands may wait in the machine for others to end; reports do not.
  const bool is_question = step == UploadStep::Report || step == UploadStep::Connect;
  if (is_question && now - heard_at_ >= settings_.silence_timeout_s) lose(now);
}

void UploadJob::onTroubleInStop(UploadStep step, const Failure& why, Arrival arrival) {
  const bool may_be_done = arrival == Arrival::Possible;
  if (!may_be_done) stop_.notDone(step);
  if (step == UploadStep::EmergencyStop) stop_.emergencyStopAnswered(why.message);
  // Whether one that may have arrived did is seen in the next report.
  if (stop_.isEmergencyStopDue() && !(step == UploadStep::EmergencyStop && may_be_done))
    command_ = UploadStep::EmergencyStop;
}

void UploadJob::onRefused(UploadStep step, const Failure& why, double now) {
  next_at_ = now;
  command_.reset();
  switch (step) {
    case UploadStep::Change:
      return onChangeFailed(why.message);
    case UploadStep::Pause:
    case UploadStep::Resume:
      record_.status.message = why.message;
      return;
    case UploadStep::Cancel:
    case UploadStep::HeatersOff:
      next_at_ = now + kReportInterval;
      return;
    case UploadStep::Remove:
      return onRemoved();  // or it is in use: the next report shows that
    case UploadStep::Disconnect:
      return close();
    case UploadStep::EmergencyStop:
      stop_.emergencyStopAnswered(why.message);
      break;
    default:
      break;
  }
  if (phase_ == Phase::Stop) return giveUpStop(now);
  const StreamableProgram& program = order_->body.program();
  if ((step == UploadStep::Upload || step == UploadStep::Verify) && program.hasChanged())
    return abort({ErrorCode::InvalidProgram, program.name() + " was changed while it was uploaded"}, now);
  abort(why, now);
}

// What the machine reports.

void UploadJob::onReport(double now) {
  heard_at_ = now;
  may_be_started_ ? account_.hearOfPrint(server()) : account_.hear(server());
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

void UploadJob::check(double now) {
  const MachineReport& report = server().report();
  if (order_->start == JobStart::Resume) return recognise(now);
  if (const auto why = hindrance(report)) return abort(*why, now);
  if (report.is_moving) return awaitIdleness(now);
  busy_since_.reset();
  phase_ = is_stored_ ? Phase::Start : Phase::Upload;
  next_at_ = now;
}

/// A print that was begun earlier is known by the name of its file, and then by its bytes; meanwhile it may
/// have ended.
void UploadJob::recognise(double now) {
  const MachineReport& report = server().report();
  if (const auto why = hindranceToGoOn(report, order_->earlier_files)) return abort(*why, now);
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
  if (const auto why = hindranceToCome(report)) {
    abort(*why, now);
  } else if (now >= started_at_ + settings_.connect_timeout_s) {
    abort({ErrorCode::TimedOut,
           "the machine has not begun the print within " + wholeSeconds(settings_.connect_timeout_s)},
          now);
  }
}

void UploadJob::follow(double now) {
  if (const auto why = endOfPrint(server())) return abort(*why, now);
  if (server().report().state == PrintState::Complete) {
    complete();
    completed_at_ = now;
  } else {
    followHold(now);
    pauseAtLayer(now);
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

void UploadJob::stop(double now) {
  const UploadStop::Verdict verdict = stop_.judge(server(), record_.status.failure.message, now);
  if (verdict.next) command_ = verdict.next;
  if (!verdict.confirmation) return;
  record_.status.failure.message += *verdict.confirmation;
  phase_ = stop_.isRemoved() ? Phase::Leave : Phase::Remove;
  next_at_ = now;
}

void UploadJob::giveUpStop(double now) {
  if (under_way_) is_to_break_ = true;
  under_way_.reset();
  if (stop_.takeEmergencyStop(server(), now)) {
    command_ = UploadStep::EmergencyStop;
    next_at_ = now;
    return;
  }
  record_.status.failure.message += stop_.remark(server());
  close();
}

// Time and commands

void UploadJob::elapse(double now) {
  if (phase_ == Phase::Stop && now >= stop_.until()) giveUpStop(now);
}

double UploadJob::nextDeadline() const {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  if (phase_ == Phase::Over || record_.status.state == PackmlState::Idle) return kNever;
  const double stop = phase_ == Phase::Stop ? stop_.until() : kNever;
  return under_way_ ? stop : std::min(stop, next_at_);
}

bool UploadJob::pause(double now) {
  const LayerPause::Wish wish = layer_pause_.pauseNow(record_);
  if (wish != LayerPause::Wish::Begun) return wish == LayerPause::Wish::Kept;
  is_to_resume_ = false;
  command_ = UploadStep::Pause;
  next_at_ = now;
  return true;
}

bool UploadJob::resume(double now) {
  if (layer_pause_.takeBack(record_)) return true;
  if (record_.status.state == PackmlState::Holding) {
    is_to_resume_ = true;
    return true;
  }
  if (record_.status.state != PackmlState::Held) return false;
  record_.enter(PackmlState::Unholding);
  command_ = UploadStep::Resume;
  next_at_ = now;
  return true;
}

void UploadJob::abort(const Failure& why, double now) {
  if (record_.isStopping() || isFinal(record_.status.state)) return;
  const bool was_starting = record_.isStarting();
  record_.beginToStop({why.code, why.message + (may_be_started_ ? record_.whereItStands() : "")});
  if (std::exchange(under_way_, std::nullopt)) is_to_break_ = true;
  command_.reset();
  attempts_ = 0;
  next_at_ = now;
  if (may_be_started_ && !was_complete_) {
    phase_ = Phase::Stop;
    stop_.begin(now);
    if (was_seen_) stop_.seen();
  } else if (phase_ == Phase::Connect || (was_starting && why.code == ErrorCode::Disconnected)) {
    close();
  } else {
    is_logged_out_ = false;
    phase_ = may_be_stored_ ? Phase::Remove : Phase::Leave;
  }
}

std::string UploadJob::change(const LiveChange& change, double now) {
  const bool is_to_come = record_.isStarting() && change.setting == LiveSetting::PauseAtLayer;
  if (!is_to_come && !(record_.isUnderWay() && phase_ == Phase::Follow)) return kNoJobToChange;
  if (layer_pause_.take(change)) return {};
  const ChangeCommand changed = server().changed(change);
  if (changed.command.empty()) return changed.refusal;
  changes_.push_back(changed.command);
  next_at_ = now;
  return {};
}

void UploadJob::onChangeFailed(const std::string& why) {
  record_.status.message = changes_.front() + ": " + why;
  changes_.pop_front();
}

/// The machine is out of reach: nothing can be done about it from here.
void UploadJob::lose(double now) {
  const std::string since = wholeSeconds(now - heard_at_);
  record_.status.failure = {
      ErrorCode::Disconnected,
      (phase_ == Phase::Finish
           ? "the machine has reported the print complete and was not heard of since, for "
           : "nothing was heard of the machine for ") +
          since + " (" + trouble_ + ")" + record_.whereItStands() + kMayStillPrint};
  record_.enter(PackmlState::Aborting);
  close();
}

void UploadJob::close() {
  phase_ = Phase::Over;
  record_.enter(record_.isStopping() ? PackmlState::Aborted : PackmlState::Complete);
}

}  // namespace lamina
