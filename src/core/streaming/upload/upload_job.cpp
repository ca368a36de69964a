// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/upload/upload_job.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/duration_text.hpp"

namespace lamina {
namespace {

constexpr double kReportInterval = 1.0;  // s; below the 8 s in which a Duet forgets a session
constexpr double kNearInterval = 0.2;    // s, in front of a layer in which it is to hold
constexpr double kRetryInterval = 2.0;   // s; Moonraker's temporary files are named by the second
constexpr int kAttempts = 3;

}  // namespace

UploadJob::UploadJob(const StreamSettings& settings, std::shared_ptr<const UploadOrder> order)
    : settings_(settings),
      order_(std::move(order)),
      servers_(printServers(settings.firmware, order_)),
      sent_line_(order_->body.program()),
      read_line_(order_->body.program()) {
  record_.status.lines_total = order_->body.program().lines();
  record_.status.starvation.source = StarvationSource::Nobody;
}

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
    asked_heaters_off_ = true;
    asked_at_ = now;
  } else if (step == UploadStep::Change) {
    server().give(changes_.front());
  } else if (step == UploadStep::Pause || step == UploadStep::Resume) {
    asked_at_ = now;
  }
}

void UploadJob::sent(std::uint64_t bytes) {
  if (under_way_ != UploadStep::Upload) return;
  record_.status.lines_sent = std::max(record_.status.lines_sent, sent_line_.linesBefore(bytes));
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
      heard_at_ = now;
      return;
    case UploadStep::Remove:
      return onRemoved();
    case UploadStep::Disconnect:
      return close();
    case UploadStep::Change:
      changes_.pop_front();
      return;
    case UploadStep::EmergencyStop:
      emergency_.is_taken = true;
      emergency_.answer = "the server has taken it";
      command_.reset();
      return;
    default:
      command_.reset();
      return;
  }
}

void UploadJob::onRemoved() {
  command_.reset();
  is_removed_ = true;
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
        heard_at_ = now;
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
  if (!may_be_done && step == UploadStep::Cancel) cancels_ = {};
  if (!may_be_done && step == UploadStep::HeatersOff) asked_heaters_off_ = false;
  if (step == UploadStep::EmergencyStop) emergency_.answer = why.message;
  // Whether one that may have arrived did is seen in the next report.
  if (isEmergencyStopDue() && !(step == UploadStep::EmergencyStop && may_be_done))
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
      emergency_.answer = why.message;
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

// Time and commands

void UploadJob::elapse(double now) {
  if (phase_ == Phase::Stop && now >= stop_until_) giveUpStop(now);
}

double UploadJob::nextDeadline() const {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  if (phase_ == Phase::Over || record_.status.state == PackmlState::Idle) return kNever;
  const double stop = phase_ == Phase::Stop ? stop_until_ : kNever;
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
  record_.status.failure = why;
  if (may_be_started_) record_.status.failure.message += record_.whereItStands();
  const bool was_starting = record_.isStarting();
  record_.enter(PackmlState::Aborting);
  if (std::exchange(under_way_, std::nullopt)) is_to_break_ = true;
  command_.reset();
  attempts_ = 0;
  next_at_ = now;
  if (may_be_started_ && !was_complete_) {
    phase_ = Phase::Stop;
    stop_until_ = now + settings_.safe_stop_timeout_s;
  } else if (phase_ == Phase::Connect || (was_starting && why.code == ErrorCode::Disconnected)) {
    close();
  } else {
    is_logged_out_ = false;
    phase_ = may_be_stored_ ? Phase::Remove : Phase::Leave;
  }
}

std::string UploadJob::change(const LiveChange& change, double now) {
  const PackmlState state = record_.status.state;
  const bool is_running =
      state == PackmlState::Execute || state == PackmlState::Holding || state == PackmlState::Held;
  const bool is_to_come = record_.isStarting() && change.setting == LiveSetting::PauseAtLayer;
  if (!is_to_come && !(is_running && phase_ == Phase::Follow)) return kNoJobToChange;
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
          since + " (" + trouble_ + ")" + record_.whereItStands() +
          "; it may still be printing, and hot: look after it"};
  record_.enter(PackmlState::Aborting);
  close();
}

void UploadJob::close() {
  phase_ = Phase::Over;
  record_.enter(record_.isStopping() ? PackmlState::Aborted : PackmlState::Complete);
}

}  // namespace lamina
