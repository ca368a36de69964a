// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/marlin/marlin_job.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/duration_text.hpp"
#include "lamina/base/error.hpp"
#include "streaming/firmware/marlin/stop_commands.hpp"
#include "streaming/job/job_failures.hpp"

namespace lamina {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
// Lines under way when a job is aborted must not be taken for those of the safe stop.
constexpr std::uint64_t kSafeStopGap = 1000;

}  // namespace

MarlinJob::MarlinJob(StreamOrder order, std::shared_ptr<const MarlinFirmware> firmware)
    : settings_(order.settings),
      firmware_(std::move(firmware)),
      heard_(std::move(order.heard)),
      program_(order.program),
      line_base_(order.line_base),
      enquiry_(order.unfinished ? std::make_unique<LineEnquiry>(order, firmware_) : nullptr),
      revised_(revisedLines(order, firmware_)),
      feed_(sourceOf(order.program, revised_), line_base_ + 1, -1, readinessOf(revised_)),
      account_(record_.status, line_base_),
      resend_(settings_),
      timer_(order.settings.probe_after_s),
      firmware_name_(std::move(order.firmware_name)),
      answers_due_(order.answers_due),
      person_(order.hears_at_once) {
  record_.status.lines_total = order.program.lines();
  reports_.begin(reportsOn(*firmware_, settings_));
}

void MarlinJob::beginPhase(Phase phase, double now) {
  phase_ = phase;
  timer_.restart(now);
}

bool MarlinJob::isWaiting() const {
  if (phase_ == Phase::Feeding) return !resend_.empty() || resend_.isWaiting() || isAwaitingLayer();
  return phase_ != Phase::Idle;
}

double MarlinJob::silenceLimit() const {
  if (phase_ == Phase::Confirming) return kNever;  // which ends by itself
  if (record_.status.state == PackmlState::Starting) return settings_.connect_timeout_s;
  const bool is_blocked = phase_ == Phase::Draining || resend_.hasBlocking();
  return is_blocked ? settings_.blocking_timeout_s : settings_.silence_timeout_s;
}

double MarlinJob::nextDeadline() const {
  if (!isWaiting()) return kNever;
  if (phase_ == Phase::Offline) return safe_stop_by_;
  if (phase_ == Phase::Enquiring) return enquiry_->nextDeadline();
  if (isAwaitingLayer()) return layer_wait_.nextLook();
  const double give_up = isStopping() ? safe_stop_by_ : timer_.quietSince() + silenceLimit();
  const double deadline = std::min(timer_.retryAt(), give_up);
  return resend_.isWaiting() ? std::min(deadline, resend_.waitsUntil()) : deadline;
}

void MarlinJob::start(double now) {
  if (record_.status.state != PackmlState::Idle) return;
  record_.enter(PackmlState::Starting);
  if (enquiry_) {
    beginPhase(Phase::Enquiring, now);
    enquiry_->start(now);
    return followEnquiry(now);
  }
  if (!firmware_name_) return identify(now);
  record_.status.firmware_name = *firmware_name_;
  beginNumbering(line_base_, now);
}

void MarlinJob::followEnquiry(double now) {
  output_ += enquiry_->takeOutput();
  if (enquiry_->failure().code != ErrorCode::Ok) {
    abort(enquiry_->failure(), now);
  } else if (enquiry_->taken()) {
    goOnAfter(*enquiry_->taken(), now);
  }
}

/// The firmware counts on from where it is: its number is what proves that no line is lost or run twice.
void MarlinJob::goOnAfter(std::uint64_t number, double now) {
  StreamStatus& status = record_.status;
  status.lines_sent = status.lines_acknowledged = number - line_base_;
  const auto pass = [&](const ProgramLine& line) {
    outputs_.see(line.command);
    status.layer = line.layer;
  };
  try {
    auto rest = restOf(program_, status.lines_acknowledged, pass);
    feed_ = LineFeed(std::move(rest), number + 1, status.layer);
  } catch (const Error&) {
    return abort(currentFailure(), now);  // the program is gone
  }
  resend_.beginAt(number + 1);
  answers_due_ = 0;  // the enquiry has waited for them
  nextReport(now);
}

void MarlinJob::beginNumbering(std::uint64_t base, double now) {
  base_ = base;
  beginPhase(Phase::Numbering, now);
  retry(now);
}

/// The firmware refuses a wrong number as soon as it reads it, but says the ok to what it has queued before
/// only when that is done.
void MarlinJob::confirm(double now) {
  resend_.waitForOks(answers_due_, now);
  if (!resend_.isWaiting()) return nextReport(now);
  if (phase_ != Phase::Confirming) beginPhase(Phase::Confirming, now);
}

void MarlinJob::nextReport(double now) {
  if (!reports_.isDone()) {
    beginPhase(Phase::Reporting, now);
    return askReport();
  }
  if (isAtRest()) return finishComplete();
  if (answers_due_ > 0) return confirm(now);
  has_begun_ = true;
  record_.enter(PackmlState::Execute);
  beginPhase(Phase::Feeding, now);
  resend_.waitForProbes(now);
  proceed(now);
}

void MarlinJob::askReport() {
  ++answers_due_;
  output_ += reports_.next() + "\n";
}

void MarlinJob::onReportDone(double now) {
  reports_.advance();
  nextReport(now);
}

/// Sends what may be sent, and takes the step that is due when nothing is under way any more.
void MarlinJob::proceed(double now) {
  resend_.settle(now);
  if (resend_.isWaiting() || beginChange(now)) return;
  if (record_.status.state == PackmlState::Execute || isStopping()) pump(now);
  if (!resend_.empty()) return;
  if (record_.status.state == PackmlState::Holding) {
    record_.enter(PackmlState::Held);
  } else if (record_.status.state == PackmlState::Execute || isStopping()) {
    if (awaitLayer(now)) return;
    // Nothing is left to send either: the machine must report that it has all.
    beginPhase(Phase::Probing, now);
    probe();
  }
}

void MarlinJob::noteSent(const ProgramLine& line, double now) {
  outputs_.see(line.command);
  if (firmware_->isBlocking(line.command)) return account_.starvation().sentWait(feed_.next(), now);
  account_.starvation().sent(feed_.next(), line.seconds, now);
}

void MarlinJob::pump(double now) {
  while (const ProgramLine* line = feed_.isNextKnown() ? feed_.peek() : nullptr) {
    unnumbered_.lineSent();
    layer_wait_.end();
    if (!isStopping() && layer_pause_.takeIfDueAt(line->layer)) {
      pause(now);
      break;
    }
    const std::string framed = firmware_->framed(feed_.next(), line->command);
    if (!resend_.hasRoom(framed.size())) break;
    if (resend_.empty()) timer_.restart(now);
    resend_.sent({feed_.next(), framed.size(), firmware_->isBlocking(line->command),
                  feed_.next() < feed_.end(), false});
    output_ += framed;
    if (!isStopping()) noteSent(*line, now);
    feed_.advance();
  }
  if (isStopping()) return;
  record_.status.lines_sent = feed_.end() - 1 - line_base_;
  if (revised_) record_.status.lines_total = revised_->total();
}

void MarlinJob::onAllTaken(double now) {
  if (!isStopping()) {
    const auto why = shortfall(feed_.end() - 1 - line_base_, record_, revised_.get());
    if (why) return abort(*why, now);
    record_.enter(PackmlState::Completing);
  }
  beginPhase(Phase::Draining, now);
  askForRest();
}

std::string MarlinJob::change(const LiveChange& change, double now) {
  if (!record_.isUnderWay()) return kNoJobToChange;
  if (layer_pause_.take(change)) return {};
  const auto command = firmware_->changed(change);
  if (!command) return notOf("this firmware", change.setting);
  unnumbered_.addChange(*command);
  if (phase_ == Phase::Feeding) proceed(now);
  return {};
}

bool MarlinJob::ask(const std::string& command, double now) {
  if (!record_.isUnderWay() || !unnumbered_.addQuestion(command)) return false;
  if (phase_ == Phase::Feeding) proceed(now);
  return true;
}

/// What becomes of a layer may depend on all that is below it: its time counts from when the machine is at
/// rest.
/// @return whether the lines of a layer wait
bool MarlinJob::awaitLayer(double now) {
  if (isStopping() || feed_.isNextKnown()) return false;
  account_.starvation().standStill();
  if (unnumbered_.addRest(firmware_->endOfMotions())) return beginChange(now);
  if (!layer_wait_.isUnderWay()) layer_wait_.begin(now + revised_->waitTime());
  layer_wait_.look(now);
  return true;
}

/// A change has no number, so that the numbers stay those of the program's lines: it goes out while no line
/// is under way.
/// @return whether lines must wait
bool MarlinJob::beginChange(double now) {
  if (unnumbered_.empty() || isStopping()) return false;
  if (!resend_.empty() || resend_.hasUnansweredProbe()) return !resend_.empty();
  beginPhase(Phase::Changing, now);
  output_ += unnumbered_.front() + "\n";
  return true;
}

void MarlinJob::elapse(double now) {
  if (!isWaiting()) return;
  if (isAwaitingLayer()) {
    if (layer_wait_.isOver(now)) revised_->decide();
    return proceed(now);
  }
  if (phase_ == Phase::Enquiring) {
    enquiry_->elapse(now);
    return followEnquiry(now);
  }
  if (isStopping() && now >= safe_stop_by_) {
    finishAborted(phase_ == Phase::Offline ? kLinkNotBack : unconfirmedStop(is_halted_));
  } else if (!isStopping() && now >= timer_.quietSince() + silenceLimit()) {
    timeOut(now);
  } else if (now >= timer_.retryAt()) {
    resend_.doubtAnswers();  // they may be late, not lost
    retry(now);
  } else if (resend_.isWaiting() && now >= resend_.waitsUntil()) {
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
      probe();
      break;
    case Phase::Reporting:
      if (reports_.mayRepeat()) return askReport();
      onReportDone(now);  // a machine without reports prints all the same
      break;
    case Phase::Feeding:
      phase_ = Phase::Probing;
      resend_.waitNoLonger();
      probe();
      break;
    case Phase::Changing:
      record_.status.message = unnumbered_.lose();
      beginPhase(Phase::Probing, now);
      probe();
      break;
    case Phase::Probing:
      probe();
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
    abort(fallenSilent(fullTenths(timer_.quietFor(now)), record_), now);
  } else if (has_answered_) {
    abort({ErrorCode::Rejected, "the machine answers, but does not check line numbers as Marlin does"}, now);
  } else {
    abort(nobodyThere(fullTenths(settings_.connect_timeout_s)), now);
  }
}

bool MarlinJob::pause(double now) {
  const LayerPause::Wish wish = layer_pause_.pauseNow(record_);
  if (wish != LayerPause::Wish::Begun) return wish == LayerPause::Wish::Kept;
  account_.starvation().standStill();
  if (phase_ == Phase::Feeding) proceed(now);
  return true;
}

bool MarlinJob::resume(double now) {
  if (layer_pause_.takeBack(record_)) return true;
  if (!record_.isPaused()) return releaseFromLastWait();
  releaseFromWait();
  layer_wait_.end();  // the time to wait for a layer begins anew
  is_paused_by_machine_ = false;
  record_.goOn();
  if (phase_ == Phase::Feeding) proceed(now);
  return true;
}

void MarlinJob::prepareSafeStop(double now) {
  safe_stop_by_ = now + settings_.safe_stop_timeout_s;
  safe_stop_latest_ = now + std::max(settings_.safe_stop_timeout_s, settings_.blocking_timeout_s);
  // With a journal beyond the program: who goes on with the job must not take these numbers for its lines'.
  const std::uint64_t end = line_base_ > 0 ? line_base_ + record_.status.lines_total : 0;
  base_ = std::max(feed_.end(), end) + kSafeStopGap;
  feed_ = LineFeed(sourceOf(safeStop(*firmware_, outputs_, settings_)), base_ + 1);
  resend_.forget();
}

void MarlinJob::abort(const Failure& why, double now) {
  if (isStopping() || isFinal(record_.status.state)) return;
  record_.beginToStop(why);
  if (!has_begun_) return finishAborted("");
  prepareSafeStop(now);
  beginNumbering(base_, now);
}

/// A machine whose link is lost goes on heating: it is asked to stop as soon as it can be reached again.
void MarlinJob::disconnect(const std::string& why, double now) {
  if (isFinal(record_.status.state) || phase_ == Phase::Offline) return;
  if (isAtRest()) return finishComplete();
  if (!isStopping()) {
    record_.beginToStop({ErrorCode::Disconnected, why + record_.whereItStands()});
    if (!has_begun_) return finishAborted("");
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
  resend_.forget();
  record_.enter(PackmlState::Aborted);
}

std::string MarlinJob::takeOutput() { return std::exchange(output_, {}); }

// What the job makes of the machine's replies.

void MarlinJob::receive(std::string_view bytes, double now) {
  replies_.add(bytes);
  while (const auto line = replies_.next()) onReply(firmware_->read(*line), now);
  if (phase_ == Phase::Feeding) proceed(now);
}

void MarlinJob::onReply(const FirmwareReply& reply, double now) {
  if (heard_) heard_(reply);
  if (phase_ == Phase::Idle) return;
  followPerson(reply, now);
  if (!reply.firmware_name.empty()) onIdentity(reply, now);
  if (reply.temperatures) record_.status.temperatures = reply.temperatures;
  if (reply.position) record_.status.position = reply.position;
  if (phase_ == Phase::Enquiring) {
    enquiry_->hear(reply, now);
    return followEnquiry(now);
  }
  const bool is_draining = phase_ == Phase::Draining && isStopping();
  if (is_draining && endsStop(reply)) return finishAborted("");
  if (reply.kind != ReplyKind::Information && reply.kind != ReplyKind::Warning) {
    has_answered_ = true;
    if (record_.status.state != PackmlState::Starting) timer_.restart(now);
  }
  // A machine that boots, or that another sender has made heat, answers later.
  const bool is_alive = reply.kind == ReplyKind::Busy || reply.temperatures;
  if (is_alive && record_.status.state == PackmlState::Starting) timer_.restart(now);
  if (!resend_.hear(reply, now)) onKind(reply, now);
}

void MarlinJob::onKind(const FirmwareReply& reply, double now) {
  switch (reply.kind) {
    case ReplyKind::Ok:
      onOk(reply, now);
      break;
    case ReplyKind::Resend:
      onResend(reply, now);
      break;
    case ReplyKind::Start:
      if (record_.isStarting()) return identify(now);
      fail(ErrorCode::DeviceError, "the machine was reset", now);
      break;
    case ReplyKind::Fatal:
      failHalted(reply, now);
      break;
    case ReplyKind::Warning:
      record_.status.message = reply.text;
      break;
    case ReplyKind::NotDone:
      record_.status.message = reply.text;
      // What is asked for besides the program's lines may be unknown.
      if (isAnsweringLines()) account_.notDone(reply.text);
      break;
    case ReplyKind::Pause:
      record_.status.message = reply.text;
      if (pause(now)) is_paused_by_machine_ = true;
      break;
    case ReplyKind::Resume:
      if (is_paused_by_machine_) resume(now);
      break;
    case ReplyKind::Cancel:
      onEnded(reply, now);
      break;
    case ReplyKind::Busy:
      account_.starvation().busy(now);
      safe_stop_by_ = std::min(now + settings_.safe_stop_timeout_s, safe_stop_latest_);
      break;
    case ReplyKind::LineError:
    case ReplyKind::Unreadable:
    case ReplyKind::Information:
      break;
  }
}

/// Marlin's kill() asks for no power, behind an error that may have been lost: nobody has cancelled that job.
void MarlinJob::onEnded(const FirmwareReply& reply, double now) {
  if (reply.text.find("cancel") != std::string::npos)
    fail(ErrorCode::Cancelled, "the machine ends the job: \"" + reply.text + "\"", now);
  else
    failHalted(reply, now);
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
    unnumbered_.answered();
    beginPhase(Phase::Feeding, now);
    proceed(now);
  } else if (phase_ == Phase::Draining && !isStopping()) {
    reports_.begin(reportsOff(*firmware_, settings_));
    beginPhase(Phase::Reporting, now);
    nextReport(now);
  } else if (phase_ == Phase::Feeding || phase_ == Phase::Probing) {
    const bool names_line = reply.line && *reply.line < feed_.end();
    const auto done = resend_.acknowledge(names_line ? reply.line : std::nullopt);
    if (done) acknowledgedUpTo(*done, reply, now);
  }
}

void MarlinJob::onResend(const FirmwareReply& reply, double now) {
  const bool is_of_probe = resend_.takeRequest();
  if (!reply.line) return;
  const std::uint64_t wanted = *reply.line;
  if (phase_ == Phase::Numbering) {
    if (wanted != base_ + 1) return;
    resend_.beginAt(wanted);
    if (isStopping()) {
      beginPhase(Phase::Feeding, now);
      proceed(now);
    } else {
      confirm(now);
    }
  } else if (phase_ == Phase::Probing) {
    if (!isRefuted(wanted, now)) onProbeAnswer(wanted, now);
  } else if (phase_ == Phase::Feeding) {
    if (is_of_probe && resend_.isRepeated(wanted)) return;
    if (isRefuted(wanted, now) || resend_.absorb(wanted) || !goTo(wanted, now)) return;
    ++record_.status.resends;
    resend_.refuse(wanted, now);
  }
}

/// Asks once more where a request contradicts what is known, and ends the job if it is repeated.
/// @return whether the request must not be followed
bool MarlinJob::isRefuted(std::uint64_t wanted, double now) {
  using Contradiction = MarlinResend::Contradiction;
  if (isStopping()) return false;
  const Contradiction found = resend_.contradictionOf(wanted, line_base_ + record_.status.lines_acknowledged);
  if (found == Contradiction::None) return false;
  if (found == Contradiction::First) {
    resend_.forget();
    beginPhase(Phase::Probing, now);
    probe();
    return true;
  }
  fail(ErrorCode::DeviceError,
       "the machine asks for line " + std::to_string(wanted) + ", which it has taken before: it was reset",
       now);
  return true;
}

/// Goes on with `line`, which the firmware has asked for.
bool MarlinJob::goTo(std::uint64_t line, double now) {
  if (!feed_.rewind(line)) {
    if (resend_.isTooOdd())
      fail(ErrorCode::Rejected,
           "the machine asks for line " + std::to_string(line) + "; expected one up to " +
               std::to_string(feed_.end()),
           now);
    return false;
  }
  const std::string trouble = resend_.follow(line);
  if (!isStopping()) account_.rewound(line, feed_.layerOf(line - 1));
  if (!trouble.empty()) fail(ErrorCode::Rejected, trouble, now);
  return trouble.empty();
}

/// Sends a line that the firmware must refuse, naming the line it waits for: a harmless one, with the number
/// after the next one.
void MarlinJob::probe() {
  ++record_.status.probes;
  resend_.probed();
  const std::uint64_t expected = phase_ == Phase::Numbering ? base_ + 1 : feed_.end();
  output_ += firmware_->framed(expected + 1, firmware_->harmless());
}

void MarlinJob::onProbeAnswer(std::uint64_t wanted, double now) {
  if (!goTo(wanted, now)) return;
  resend_.allRead(now);
  if (wanted < feed_.end()) ++record_.status.resends;
  beginPhase(Phase::Feeding, now);
  const bool may_feed = record_.status.state == PackmlState::Execute || isStopping();
  if (!may_feed || !feed_.isNextKnown() || feed_.peek() != nullptr) return;
  // Changes outlive the job: those that wait go out before its end.
  const bool is_change_due = !unnumbered_.empty() && !isStopping();
  if (!is_change_due) onAllTaken(now);
}

void MarlinJob::acknowledgedUpTo(std::uint64_t line, const FirmwareReply& reply, double now) {
  if (isStopping() || line <= line_base_ + record_.status.lines_acknowledged) return;
  account_.taken(line, feed_.layerOf(line), reply.free_planner_blocks, now);
  resend_.proven();
}

/// A job has ended when its motions have. A safe stop has ended when the machine says that it no longer
/// heats: the lines it has taken may still wait behind others.
void MarlinJob::askForRest() {
  output_ += (isStopping() ? firmware_->harmless() : firmware_->endOfMotions()) + "\n";
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
