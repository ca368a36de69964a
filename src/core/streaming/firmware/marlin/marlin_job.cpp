// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/marlin/marlin_job.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/duration_text.hpp"
#include "streaming/firmware/marlin/stop_commands.hpp"

namespace lamina {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr int kReportAttempts = 3;

LineFeed feedOf(const StreamableProgram& program, const std::shared_ptr<RevisedLines>& revised,
                std::uint64_t first) {
  if (!revised) return LineFeed(sourceOf(program), first);
  return LineFeed([revised] { return revised->next(); }, first, -1,
                  [revised] { return revised->isNextKnown(); });
}

}  // namespace

MarlinJob::MarlinJob(StreamOrder order, std::shared_ptr<const MarlinFirmware> firmware)
    : settings_(order.settings),
      firmware_(std::move(firmware)),
      heard_(std::move(order.heard)),
      program_(order.program),
      line_base_(order.line_base),
      enquiry_(order.unfinished ? std::make_unique<LineEnquiry>(order, firmware_) : nullptr),
      revised_(revisedLines(order, firmware_)),
      feed_(feedOf(order.program, revised_, line_base_ + 1)),
      timer_(order.settings.probe_after_s),
      firmware_name_(std::move(order.firmware_name)),
      answers_due_(order.answers_due) {
  settings_.window_lines = windowLines(settings_, settings_.link);
  record_.status.lines_total = order.program.lines();
  reports_ = reportsOn(*firmware_, settings_);
}

void MarlinJob::beginPhase(Phase phase, double now) {
  phase_ = phase;
  timer_.restart(now);
}

bool MarlinJob::isWaiting() const {
  if (phase_ == Phase::Feeding) return !sent_.empty() || isSettling() || isAwaitingLayer();
  return phase_ != Phase::Idle;
}

double MarlinJob::silenceLimit() const {
  if (record_.status.state == PackmlState::Starting) return settings_.connect_timeout_s;
  const bool is_blocked = phase_ == Phase::Draining || sent_.hasBlocking();
  return is_blocked ? settings_.blocking_timeout_s : settings_.silence_timeout_s;
}

double MarlinJob::nextDeadline() const {
  if (!isWaiting()) return kNever;
  if (phase_ == Phase::Offline) return safe_stop_by_;
  if (phase_ == Phase::Enquiring) return enquiry_->nextDeadline();
  if (isAwaitingLayer()) return next_look_;
  const double give_up = isStopping() ? safe_stop_by_ : timer_.quietSince() + silenceLimit();
  const double deadline = std::min(timer_.retryAt(), give_up);
  return isSettling() ? std::min(deadline, settle_until_) : deadline;
}

/// Sends what may be sent, and takes the step that is due when nothing is under way any more.
void MarlinJob::proceed(double now) {
  settle(now);
  if (isSettling() || beginChange(now)) return;
  if (record_.status.state == PackmlState::Execute || isStopping()) pump(now);
  if (!sent_.empty()) return;
  if (record_.status.state == PackmlState::Holding) {
    record_.enter(PackmlState::Held);
  } else if (record_.status.state == PackmlState::Execute || isStopping()) {
    if (awaitLayer(now)) return;
    // Nothing is left to send either: the machine must report that it has all.
    beginPhase(Phase::Probing, now);
    probe(now);
  }
}

bool MarlinJob::hasRoom(std::size_t bytes) const {
  if (sent_.empty() || must_send_one_) return true;
  return sent_.count() < static_cast<std::size_t>(settings_.window_lines) &&
         sent_.bytes() + bytes <= static_cast<std::size_t>(settings_.window_bytes);
}

void MarlinJob::noteSent(const ProgramLine& line, double now) {
  outputs_.see(line.command);
  if (firmware_->isBlocking(line.command)) return starvation_.sentWait(feed_.next(), now);
  starvation_.sent(feed_.next(), line.seconds, now);
}

void MarlinJob::pump(double now) {
  while (const ProgramLine* line = feed_.isNextKnown() ? feed_.peek() : nullptr) {
    is_rest_asked_ = false;
    layer_due_ = 0.0;
    if (!isStopping() && layer_pause_.takeIfDueAt(line->layer)) {
      pause(now);
      break;
    }
    const std::string framed = firmware_->framed(feed_.next(), line->command);
    if (!hasRoom(framed.size())) break;
    if (sent_.empty()) timer_.restart(now);
    must_send_one_ = false;
    sent_.add({feed_.next(), framed.size(), firmware_->isBlocking(line->command), feed_.next() < feed_.end(),
               false});
    output_ += framed;
    if (!isStopping()) noteSent(*line, now);
    feed_.advance();
  }
  if (isStopping()) return;
  record_.status.lines_sent = feed_.end() - 1 - line_base_;
  if (revised_) record_.status.lines_total = revised_->total();
}

void MarlinJob::onAllTaken(double now) {
  if (!isStopping() && revised_ && revised_->failure().code != ErrorCode::Ok)
    return abort({revised_->failure().code, revised_->failure().message + record_.whereItStands()}, now);
  const std::uint64_t lines_read = feed_.end() - 1 - line_base_;
  if (!isStopping() && lines_read < record_.status.lines_total) {
    abort({ErrorCode::InvalidProgram, "the program was changed while it was streamed: it ended after line " +
                                          std::to_string(lines_read) + " of " +
                                          std::to_string(record_.status.lines_total)},
          now);
    return;
  }
  if (!isStopping()) record_.enter(PackmlState::Completing);
  beginPhase(Phase::Draining, now);
  askForRest();
}

void MarlinJob::elapse(double now) {
  if (!isWaiting()) return;
  if (isAwaitingLayer()) {
    if (now >= layer_due_) revised_->decide();
    return proceed(now);
  }
  if (phase_ == Phase::Enquiring) {
    enquiry_->elapse(now);
    return followEnquiry(now);
  }
  if (isStopping() && now >= safe_stop_by_) {
    finishAborted(
        phase_ == Phase::Offline
            ? "; the link did not come back, so that the machine was not commanded to stop: look after it"
            : "; the machine did not confirm the safe stop");
  } else if (!isStopping() && now >= timer_.quietSince() + silenceLimit()) {
    timeOut(now);
  } else if (now >= timer_.retryAt()) {
    proof_.doubt(settings_.window_lines + 2);  // answers to what was sent may be late, not lost
    retry(now);
  } else if (isSettling() && now >= settle_until_) {
    if (phase_ != Phase::Confirming) return proceed(now);
    answers_due_ = 0;  // they were lost
    confirm(now);
  }
}

void MarlinJob::retry(double now) {
  timer_.asked(now);
  switch (phase_) {
    case Phase::Identifying:
      ++answers_due_;
      output_ += firmware_->identification() + "\n";
      break;
    case Phase::Numbering:
      if (isStopping()) output_ += urgentStop(*firmware_, outputs_, settings_);
      ++answers_due_;
      output_ += firmware_->framed(base_, firmware_->numberedFrom(base_));
      probe(now);
      break;
    case Phase::Reporting:
      if (++report_attempts_ < kReportAttempts) {
        ++answers_due_;
        output_ += reports_.back() + "\n";
      } else {
        onReportDone(now);  // a machine without reports prints all the same
      }
      break;
    case Phase::Feeding:
      phase_ = Phase::Probing;
      settle_until_ = 0.0;
      probe(now);
      break;
    case Phase::Changing:
      record_.status.message = "no answer to " + changes_.front() + ", which may not have been done";
      changes_.clear();
      beginPhase(Phase::Probing, now);
      probe(now);
      break;
    case Phase::Probing:
      probe(now);
      break;
    case Phase::Draining:
      askForRest();
      break;
    case Phase::Idle:
    case Phase::Enquiring:
    case Phase::Confirming:
    case Phase::Offline:
      break;
  }
}

void MarlinJob::timeOut(double now) {
  if (record_.status.state != PackmlState::Starting) {
    abort({ErrorCode::TimedOut,
           "no answer from the machine for " + fullTenths(timer_.quietFor(now)) + record_.whereItStands()},
          now);
  } else if (has_answered_) {
    abort({ErrorCode::Rejected, "the machine answers, but does not check line numbers as Marlin does"}, now);
  } else {
    abort({ErrorCode::TimedOut, "no machine answered within " + fullTenths(settings_.connect_timeout_s) +
                                    "; is it on, and is the baud rate right?"},
          now);
  }
}

bool MarlinJob::pause(double now) {
  if (record_.status.state == PackmlState::Starting) {
    layer_pause_.setNextLine();
    return true;
  }
  if (record_.status.state != PackmlState::Execute) return false;
  layer_pause_.clearNextLine();
  record_.enter(PackmlState::Holding);
  starvation_.standStill();
  if (phase_ == Phase::Feeding) proceed(now);
  return true;
}

bool MarlinJob::resume(double now) {
  if (record_.status.state == PackmlState::Starting) {
    layer_pause_.clearNextLine();
    return true;
  }
  if (record_.status.state != PackmlState::Held && record_.status.state != PackmlState::Holding) return false;
  layer_due_ = 0.0;  // the time to wait for a layer begins anew
  is_paused_by_machine_ = false;
  if (record_.status.state == PackmlState::Holding) record_.enter(PackmlState::Held);
  record_.enter(PackmlState::Unholding);
  record_.enter(PackmlState::Execute);
  if (phase_ == Phase::Feeding) proceed(now);
  return true;
}

void MarlinJob::abort(const Failure& why, double now) {
  if (isStopping() || isFinal(record_.status.state)) return;
  record_.status.failure = why;
  record_.enter(PackmlState::Aborting);
  if (!has_begun_) {
    finishAborted("");
    return;
  }
  prepareSafeStop(now);
  beginNumbering(base_, now);
}

/// A machine whose link is lost goes on heating: it is asked to stop as soon as it can be reached again.
void MarlinJob::disconnect(const std::string& why, double now) {
  if (isFinal(record_.status.state) || phase_ == Phase::Offline) return;
  if (isAtRest()) return finishComplete();
  if (!isStopping()) {
    record_.status.failure = {ErrorCode::Disconnected, why + record_.whereItStands()};
    record_.enter(PackmlState::Aborting);
    if (!has_begun_) {
      finishAborted("");
      return;
    }
    prepareSafeStop(now);
  }
  replies_.clear();
  output_.clear();
  phase_ = Phase::Offline;
}

void MarlinJob::reconnect(double now) {
  if (phase_ != Phase::Offline) return;
  safe_stop_by_ = now + settings_.safe_stop_timeout_s;
  beginNumbering(base_, now);
}

void MarlinJob::finishComplete() {
  phase_ = Phase::Idle;
  record_.enter(PackmlState::Complete);
}

void MarlinJob::finishAborted(const std::string& remark) {
  record_.status.failure.message += remark;
  phase_ = Phase::Idle;
  sent_.clear();
  record_.enter(PackmlState::Aborted);
}

std::string MarlinJob::takeOutput() { return std::exchange(output_, {}); }

// What the streamer makes of the machine's replies.

void MarlinJob::receive(std::string_view bytes, double now) {
  replies_.add(bytes);
  while (const auto line = replies_.next()) onReply(firmware_->read(*line), now);
  if (phase_ == Phase::Feeding) proceed(now);
}

void MarlinJob::onReply(const FirmwareReply& reply, double now) {
  if (heard_) heard_(reply);
  if (phase_ == Phase::Idle) return;
  if (!reply.firmware_name.empty()) onIdentity(reply, now);
  if (reply.temperatures) record_.status.temperatures = reply.temperatures;
  if (reply.position) record_.status.position = reply.position;
  if (phase_ == Phase::Enquiring) return hearEnquiry(reply, now);
  if (phase_ == Phase::Draining && isStopping() && reply.temperatures && isSafe(*reply.temperatures))
    return finishAborted("");
  const bool is_ok_of_resend = std::exchange(expects_ok_of_resend_, false) && reply.kind == ReplyKind::Ok;
  if (reply.kind != ReplyKind::Information && reply.kind != ReplyKind::Warning) {
    has_answered_ = true;
    if (record_.status.state != PackmlState::Starting) timer_.restart(now);
    if (isSettling()) settle_until_ = now + settings_.settle_s;
  }
  // A machine that boots, or that another sender has made heat, answers later.
  const bool is_alive = reply.kind == ReplyKind::Busy || reply.temperatures;
  if (is_alive && record_.status.state == PackmlState::Starting) timer_.restart(now);
  proof_.hear(reply);
  switch (reply.kind) {
    case ReplyKind::Ok:
      if (!is_ok_of_resend) onOk(reply, now);
      break;
    case ReplyKind::Resend:
      onResend(reply, now);
      break;
    case ReplyKind::Start:
      onStart(now);
      break;
    case ReplyKind::Fatal:
      onFatal(reply, now);
      break;
    case ReplyKind::Warning:
      record_.status.message = reply.text;
      break;
    case ReplyKind::NotDone:
      onNotDone(reply);
      break;
    case ReplyKind::Pause:
      onPause(reply, now);
      break;
    case ReplyKind::Resume:
      onResume(now);
      break;
    case ReplyKind::Cancel:
      abort({ErrorCode::Cancelled,
             "the machine ends the job: \"" + reply.text + "\"" + record_.whereItStands()},
            now);
      break;
    case ReplyKind::Busy:
      starvation_.busy(now);
      safe_stop_by_ = std::min(now + settings_.safe_stop_timeout_s, safe_stop_latest_);
      break;
    case ReplyKind::LineError:
    case ReplyKind::Unreadable:
    case ReplyKind::Information:
      break;
  }
}

void MarlinJob::onOk(const FirmwareReply& reply, double now) {
  if (phase_ == Phase::Identifying) {
    --answers_due_;
    beginNumbering(line_base_, now);
  } else if (phase_ == Phase::Numbering || phase_ == Phase::Confirming) {
    --answers_due_;
    if (phase_ == Phase::Confirming) confirm(now);
    // A machine that answers, but not the probe, has not had it whole.
    if (phase_ == Phase::Numbering && answers_due_ <= 0) timer_.askBy(now + settings_.settle_s);
  } else if (phase_ == Phase::Reporting) {
    --answers_due_;
    onReportDone(now);
  } else if (phase_ == Phase::Changing) {
    changes_.pop_front();
    beginPhase(Phase::Feeding, now);
    proceed(now);
  } else if (phase_ == Phase::Draining && !isStopping()) {
    reports_ = reportsOff(*firmware_, settings_);
    report_attempts_ = 0;
    beginPhase(Phase::Reporting, now);
    nextReport(now);
  } else if (phase_ == Phase::Feeding || phase_ == Phase::Probing) {
    odd_requests_ = 0;
    if (reply.line && *reply.line < feed_.end()) {
      sent_.acknowledgeUpTo(*reply.line);
      acknowledgedUpTo(*reply.line, reply, now);
    } else if (const auto number = sent_.acknowledge()) {
      acknowledgedUpTo(*number, reply, now);
    }
  }
}

void MarlinJob::acknowledgedUpTo(std::uint64_t line, const FirmwareReply& reply, double now) {
  if (isStopping() || line <= line_base_ + record_.status.lines_acknowledged) return;
  starvation_.acknowledged(line, reply.free_planner_blocks, now);
  record_.status.starvation = starvation_.starvation();
  undone_.acknowledge(line);
  record_.status.commands_not_done = undone_.count();
  proof_.acknowledged();
  record_.status.lines_acknowledged = line - line_base_;
  record_.status.layer = feed_.layerOf(line);
}

/// A job has ended when its motions have. A safe stop has ended when the machine says that it no longer
/// heats: the lines it has taken may still wait behind others.
void MarlinJob::askForRest() {
  output_ += (isStopping() ? firmware_->harmless() : firmware_->endOfMotions()) + "\n";
}

void MarlinJob::onStart(double now) {
  if (record_.status.state == PackmlState::Starting) return identify(now);
  abort({ErrorCode::DeviceError, "the machine was reset" + record_.whereItStands()}, now);
}

void MarlinJob::onFatal(const FirmwareReply& reply, double now) {
  abort({ErrorCode::Rejected, "the machine halted: \"" + reply.text + "\"" + record_.whereItStands()}, now);
}

void MarlinJob::onPause(const FirmwareReply& reply, double now) {
  record_.status.message = reply.text;
  if (pause(now)) is_paused_by_machine_ = true;
}

void MarlinJob::onNotDone(const FirmwareReply& reply) {
  record_.status.message = reply.text;
  if (isStopping()) return;
  if (undone_.count() == 0) record_.status.first_not_done = reply.text;
  undone_.announce();
}

/// Nothing but the question for its name has been sent yet.
void MarlinJob::onIdentity(const FirmwareReply& reply, double now) {
  record_.status.firmware_name = reply.firmware_name;
  if (phase_ != Phase::Identifying || firmware_->isSpokenBy(reply.firmware_name)) return;
  abort({ErrorCode::Rejected, "the machine's firmware is \"" + reply.firmware_name +
                                  "\", which does not speak " + settings_.firmware +
                                  "; expected stream.firmware auto, or that firmware"},
        now);
}

}  // namespace lamina
