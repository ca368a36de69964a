// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/ok_paced/ok_paced_job.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/duration_text.hpp"
#include "streaming/job/job_failures.hpp"

namespace lamina {

std::unique_ptr<StreamJob> OkPacedFirmware::begin(StreamOrder order) const {
  if (order.settings.link == LinkKind::Lossy && !detectsDamage()) order.settings.link = LinkKind::Reliable;
  return std::make_unique<OkPacedJob>(std::move(order), shared_from_this());
}

OkPacedJob::OkPacedJob(StreamOrder order, std::shared_ptr<const OkPacedFirmware> firmware)
    : settings_(order.settings),
      firmware_(std::move(firmware)),
      heard_(std::move(order.heard)),
      checked_program_(order.program),
      revised_(revisedLines(order, firmware_)),
      lines_(order.program, revised_),
      quotation_(order.program.quotation()),
      feed_([this] { return nextLine(); }, 1, -1, [this] { return lines_.isNextKnown(); }),
      account_(record_.status, 0),
      timer_(order.settings.probe_after_s),
      reports_(order.settings),
      opening_(firmware_->opening(order.settings.link)),
      stop_(order.settings, firmware_) {
  // Such firmware runs what it has read behind a line that it refuses.
  if (settings_.window_lines == 0) settings_.window_lines = 1;
  if (isLossy()) settings_.window_lines = 1;
  record_.status.lines_total = order.program.lines();
  if (order.firmware_name) record_.status.firmware_name = *order.firmware_name;
}

std::optional<ProgramLine> OkPacedJob::nextLine() {
  auto line = lines_.next();
  record_.status.lines_total = lines_.total();
  return line;
}

void OkPacedJob::beginPhase(Phase phase, double now) {
  phase_ = phase;
  questions_.begin();
  timer_.restart(now);
}

bool OkPacedJob::isWaiting() const {
  if (phase_ == Phase::Feeding) return !under_way_.empty() || isAwaitingLayer();
  return phase_ != Phase::Idle;
}

double OkPacedJob::silenceLimit() const {
  if (record_.isStarting()) return settings_.connect_timeout_s;
  const bool is_ending = phase_ == Phase::Locating && aim_ == Aim::End;
  if (is_ending || under_way_.hasBlocking()) return settings_.blocking_timeout_s;
  return settings_.silence_timeout_s + longest_motion_s_;
}

double OkPacedJob::nextDeadline() const {
  if (!isWaiting()) return std::numeric_limits<double>::infinity();
  if (phase_ == Phase::Offline) return stop_.giveUpAt();
  if (isAwaitingLayer()) return layer_wait_.nextLook();
  const double give_up = isStopping() ? stop_.giveUpAt() : timer_.quietSince() + silenceLimit();
  return std::min(timer_.retryAt(), give_up);
}

void OkPacedJob::send(const std::string& command, PacedCommand as) {
  // On a lossy link a lost end of line must not join this line to the one before.
  const std::string framed = (isLossy() ? "\n" : "") + firmware_->framed(next_number_++, command);
  as.bytes = framed.size();
  output_ += framed;
  unanswered_.sent();
  if (phase_ == Phase::Feeding) under_way_.add(as);
}

bool OkPacedJob::hasRoomFor(std::size_t commands) const {
  return unanswered_.count() + commands <= firmware_->mostUnanswered();
}

/// Whether one command more can be sent, and then a safe stop with its question.
bool OkPacedJob::leavesRoomForStop() const { return hasRoomFor(1 + stop_.commands(outputs_).size() + 1); }

void OkPacedJob::ask() {
  PacedCommand as;
  as.question = questions_.ask();
  send(firmware_->question(as.question, settings_.link), as);
  unanswered_.isQuestion(as.question);
}

void OkPacedJob::start(double now) {
  if (record_.status.state != PackmlState::Idle) return;
  record_.enter(PackmlState::Starting);
  beginPhase(Phase::Opening, now);
  askOpening(now);
}

void OkPacedJob::askOpening(double now) {
  opening_answer_.clear();
  timer_.asked(now);
  send(opening_[step_], {});
}

void OkPacedJob::onOpeningOk(double now) {
  const OpeningVerdict verdict = firmware_->judge(opening_[step_], std::exchange(opening_answer_, {}));
  if (verdict.kind == OpeningVerdict::Kind::Refused) {
    abort({ErrorCode::Rejected, verdict.why}, now);
  } else if (verdict.kind == OpeningVerdict::Kind::NotYet) {
    not_yet_ = verdict.why;
  } else if (++step_ < opening_.size()) {
    timer_.restart(now);
    askOpening(now);
  } else {
    locate(Aim::Begin, now);
  }
}

/// Asks until the last question is answered.
void OkPacedJob::locate(Aim aim, double now) {
  aim_ = aim;
  beginPhase(Phase::Locating, now);
  if (aim == Aim::Doubt || aim == Aim::End) ++record_.status.probes;
  timer_.asked(now);
  ask();
}

void OkPacedJob::onLocated(double now) {
  const Aim aim = aim_;
  if (aim == Aim::Doubt) return decide(now);
  const auto& answer = questions_.answer();
  if (answer && answer->position) tracker_.locate(*answer->position);
  if (aim == Aim::End) {
    phase_ = Phase::Idle;
    record_.enter(PackmlState::Complete);
    return;
  }
  under_way_.clear();
  beginPhase(Phase::Feeding, now);
  if (aim == Aim::Begin) {
    has_begun_ = true;
    record_.enter(PackmlState::Execute);
  }
}

/// Whether the line under way ran, and goes on from there; or nobody knows, and the job ends.
void OkPacedJob::decide(double now) {
  // Among the oks heard may be that of a change.
  const bool is_ok_of_line = questions_.isLineAnswered() && !under_way_.hasChange();
  const std::string change = under_way_.changeNext();
  const auto line = under_way_.takeOldestLine();
  const auto position = questions_.answer()->position;
  RunEvidence evidence = RunEvidence::None;
  if (position) evidence = tracker_.evidence(*position);
  if (is_ok_of_line) evidence = RunEvidence::Ran;
  if (evidence == RunEvidence::None && tracker_.isRepeatable()) evidence = RunEvidence::DidNotRun;
  under_way_.clear();
  beginPhase(Phase::Feeding, now);
  if (!change.empty()) record_.status.message = noAnswerTo(change);
  if (!line) return;
  if (evidence == RunEvidence::None) {
    feed_.rewind(line->line);
    return fail(ErrorCode::DeviceError,
                "it is not known whether the machine ran line " + std::to_string(line->line) + ", " +
                    quotation_.of(feed_.peek()->command) + ", whose ok did not come; it was not sent again",
                now);
  }
  if (evidence == RunEvidence::Ran) {
    acknowledge(*line, now);
  } else {
    ++record_.status.resends;
    account_.repeated(line->line);
    feed_.rewind(line->line);
  }
  if (position) tracker_.locate(*position);
}

void OkPacedJob::acknowledge(const PacedCommand& command, double now) {
  if (command.line == 0) return;
  tracker_.confirm();
  if (command.line > record_.status.lines_total) return;
  account_.taken(command.line, feed_.layerOf(command.line), std::nullopt, now);
}

/// Sends what may be sent, and takes the step that is due when nothing is under way any more.
void OkPacedJob::proceed(double now) {
  if (phase_ != Phase::Feeding) return;
  sendChanges();
  const PackmlState state = record_.status.state;
  if (state == PackmlState::Execute || state == PackmlState::Completing) pump(now);
  if (phase_ != Phase::Feeding || under_way_.lines() > 0) return;
  if (state == PackmlState::Holding) {
    record_.enter(PackmlState::Held);
  } else if (state == PackmlState::Execute || state == PackmlState::Completing) {
    if (!feed_.isNextKnown()) return awaitLayer(now);
    if (feed_.peek() == nullptr) onAllTaken(now);
  }
}

/// What becomes of a layer may depend on all that is below it: its time counts from when the machine is at
/// rest.
void OkPacedJob::awaitLayer(double now) {
  account_.starvation().standStill();
  if (!layer_wait_.isUnderWay()) layer_wait_.begin(now + revised_->waitTime());
  layer_wait_.look(now);
}

void OkPacedJob::onAllTaken(double now) {
  if (const auto why = shortfall(lines_.given(), record_, revised_.get())) return abort(*why, now);
  locate(Aim::End, now);
}

void OkPacedJob::pump(double now) {
  while (phase_ == Phase::Feeding && sendNext(now)) {
  }
  lines_.count();
  record_.status.lines_total = lines_.total();
  record_.status.lines_sent = std::min(feed_.end() - 1, record_.status.lines_total);
}

/// @return whether a line was sent
bool OkPacedJob::sendNext(double now) {
  // Behind a change there is no line: a refusal could be of either where an ok is lost.
  const bool may_send = feed_.isNextKnown() && !under_way_.hasChange() && waiting_changes_.empty();
  const ProgramLine* line = may_send ? feed_.peek() : nullptr;
  if (line == nullptr) return false;
  layer_wait_.end();
  const std::size_t lines = under_way_.lines();
  if (lines > 0 && lines >= static_cast<std::size_t>(settings_.window_lines)) return false;
  constexpr std::size_t kMostFrameBytes = 24;
  if (lines > 0 && !leavesRoomForStop()) return false;
  const std::size_t bytes = under_way_.bytes() + line->command.size() + kMostFrameBytes;
  if (lines > 0 && bytes > static_cast<std::size_t>(settings_.window_bytes)) return false;
  if (layer_pause_.takeIfDueAt(line->layer)) return !pause(now);
  const bool is_end = feed_.next() > record_.status.lines_total;
  if (is_end && lines > 0) return false;
  if (is_end && record_.status.state == PackmlState::Execute) record_.enter(PackmlState::Completing);
  if (isLossy() && tracker_.needsPosition(line->command)) {
    if (lines == 0) locate(Aim::Base, now);
    return false;
  }
  if (under_way_.empty()) timer_.restart(now);
  poll(now);
  tracker_.expect(line->command);
  if (!isLossy()) tracker_.confirm();  // only the time of motions is of interest
  longest_motion_s_ = std::max(longest_motion_s_, tracker_.seconds());
  PacedCommand as;
  as.line = feed_.next();
  as.is_blocking = firmware_->isBlocking(line->command);
  const std::string command = line->command;
  outputs_.see(command);
  if (as.is_blocking)
    account_.starvation().sentWait(as.line, now);
  else
    account_.starvation().sent(as.line, line->seconds, now);
  feed_.advance();
  send(command, as);
  return true;
}

/// Asks for the temperatures and the position, where an ok more or less is no matter.
void OkPacedJob::poll(double now) {
  if (isLossy() || under_way_.hasOthers()) return;
  for (const std::string& command : reports_.takeDue(now)) send(command, {});
}

void OkPacedJob::elapse(double now) {
  if (!isWaiting()) return;
  if (isAwaitingLayer()) {
    if (layer_wait_.isOver(now)) revised_->decide();
    return proceed(now);
  }
  if (isStopping() && now >= stop_.giveUpAt()) {
    onStopTimeout(now);
  } else if (!isStopping() && now >= timer_.quietSince() + silenceLimit()) {
    timeOut(now);
  } else if (now >= timer_.retryAt()) {
    retry(now);
  }
}

void OkPacedJob::retry(double now) {
  timer_.asked(now);
  switch (phase_) {
    case Phase::Opening:
      askOpening(now);
      break;
    case Phase::Locating:
      if (!leavesRoomForStop()) break;
      ask();
      break;
    case Phase::Feeding:
      if (isLossy()) return locate(Aim::Doubt, now);
      if (!leavesRoomForStop()) break;
      ++record_.status.probes;
      ask();
      break;
    case Phase::Stopping:
      repeatStop(now);
      break;
    case Phase::Idle:
    case Phase::Offline:
      break;
  }
}

void OkPacedJob::timeOut(double now) {
  if (!record_.isStarting()) {
    abort(fallenSilent(wholeSeconds(timer_.quietFor(now)), record_), now);
  } else if (!not_yet_.empty()) {
    abort({ErrorCode::Rejected, not_yet_}, now);
  } else if (has_answered_) {
    abort({ErrorCode::Rejected,
           "the machine answers, but not to \"" +
               (phase_ == Phase::Opening ? opening_[step_]
                                         : firmware_->question(questions_.last(), settings_.link)) +
               "\" as " + settings_.firmware + " does"},
          now);
  } else {
    abort(nobodyThere(wholeSeconds(settings_.connect_timeout_s)), now);
  }
}

bool OkPacedJob::pause(double now) {
  const LayerPause::Wish wish = layer_pause_.pauseNow(record_);
  if (wish != LayerPause::Wish::Begun) return wish == LayerPause::Wish::Kept;
  account_.starvation().standStill();
  proceed(now);
  return true;
}

bool OkPacedJob::resume(double now) {
  if (layer_pause_.takeBack(record_)) return true;
  if (!record_.isPaused()) return false;
  layer_wait_.end();  // the time to wait for a layer begins anew
  endPauseOfMachine();
  record_.goOn();
  proceed(now);
  return true;
}

std::string OkPacedJob::change(const LiveChange& change, double) {
  if (!record_.isUnderWay() || phase_ != Phase::Feeding) return kNoJobToChange;
  if (layer_pause_.take(change)) return {};
  const ChangeCommand changed = firmware_->changed(change, checked_program_);
  if (changed.command.empty()) return changed.refusal;
  if (!leavesRoomForStop()) {
    return "the machine waits, and has " + std::to_string(unanswered_.count()) +
           " commands to answer; expected fewer, so that it hears a stop";
  }
  waiting_changes_.push_back(changed.command);
  sendChanges();
  return {};
}

/// Where an ok may be lost, nothing else is under way with a change: what is answered would not be known.
void OkPacedJob::sendChanges() {
  for (; !waiting_changes_.empty() && (!isLossy() || under_way_.empty()); waiting_changes_.pop_front())
    send(waiting_changes_.front(), {0, 0, waiting_changes_.front()});
}

void OkPacedJob::abort(const Failure& why, double now) {
  if (isStopping() || isFinal(record_.status.state)) return;
  record_.beginToStop(why);
  if (!has_begun_) return finishAborted("");
  prepareStop(now);
  beginPhase(Phase::Stopping, now);
  sendStop(now);
}

void OkPacedJob::prepareStop(double now) {
  stop_.begin(now);
  under_way_.clear();
}

void OkPacedJob::sendStop(double now) {
  timer_.asked(now);
  stop_.sent();
  for (const std::string& command : stop_.commands(outputs_)) send(command, {});
  ask();
}

/// Klipper that waits for heat keeps what it is sent, and with too much of it would not hear an emergency
/// stop either.
void OkPacedJob::repeatStop(double now) {
  if (stop_.isAwaitingReason()) return;
  if (hasRoomFor(stop_.commands(outputs_).size() + 1)) sendStop(now);
}

void OkPacedJob::prolongStop(double now) {
  const std::string delay = stop_.prolong(now);
  if (!delay.empty()) record_.status.message = delay;
}

void OkPacedJob::onStopTimeout(double now) {
  if (phase_ == Phase::Offline) return finishAborted(kLinkNotBack);
  const std::string emergency = stop_.takeEmergencyStop(now);
  if (emergency.empty()) return finishAborted(stop_.remark());
  record_.status.failure.message += "; the safe stop was not confirmed within " +
                                    wholeSeconds(settings_.safe_stop_timeout_s) +
                                    ", so that an emergency stop was sent";
  output_ += emergency + "\n";
}

void OkPacedJob::onStopAnswer(double now) {
  if (stop_.isAwaitingRest()) return finishAborted("");
  if (!stop_.awaitRest(now)) return;
  timer_.restart(now);
  sendStop(now);
}

/// A machine whose link is lost goes on heating: it is asked to stop as soon as it can be reached again.
void OkPacedJob::disconnect(const std::string& why, double now) {
  if (isFinal(record_.status.state) || phase_ == Phase::Offline) return;
  if (!isStopping()) {
    record_.beginToStop({ErrorCode::Disconnected, why + record_.whereItStands()});
    if (!has_begun_) return finishAborted("");
    prepareStop(now);
  }
  replies_.clear();
  output_.clear();
  phase_ = Phase::Offline;
}

void OkPacedJob::reconnect(double now) {
  if (phase_ != Phase::Offline) return;
  unanswered_.forget();
  stop_.beginAgain(now);
  beginPhase(Phase::Stopping, now);
  sendStop(now);
}

void OkPacedJob::finishAborted(const std::string& remark) {
  record_.status.failure.message += remark;
  phase_ = Phase::Idle;
  under_way_.clear();
  record_.enter(PackmlState::Aborted);
}

std::string OkPacedJob::takeOutput() { return std::exchange(output_, {}); }

// What the job makes of the machine's replies.

void OkPacedJob::receive(std::string_view bytes, double now) {
  replies_.add(bytes);
  while (const auto line = replies_.next()) onReply(firmware_->read(*line), now);
  proceed(now);
}

void OkPacedJob::onReply(const PacedReply& heard, double now) {
  const FirmwareReply& reply = heard.reply;
  if (heard_) heard_(reply);
  if (phase_ == Phase::Idle || phase_ == Phase::Offline) return;
  if (!reply.firmware_name.empty()) record_.status.firmware_name = reply.firmware_name;
  if (reply.position) record_.status.position = reply.position;
  if (reply.temperatures) record_.status.temperatures = reply.temperatures;
  stop_.hear(heard);
  if (phase_ == Phase::Opening || phase_ == Phase::Stopping) opening_answer_.push_back(reply.text);
  const bool is_alive = reply.temperatures || reply.kind == ReplyKind::Busy;
  if (is_alive && isStopping()) prolongStop(now);
  const bool is_answer = heard.sync_answer || reply.kind == ReplyKind::Ok;
  if (heard.sync_answer) unanswered_.onAnswer(heard.sync_answer->question);
  if (reply.kind == ReplyKind::Ok) unanswered_.onOk();
  has_answered_ = has_answered_ || is_answer;
  if (is_alive || (is_answer && phase_ == Phase::Feeding)) timer_.restart(now);
  if (heard.sync_answer) onAnswer(*heard.sync_answer, now);
  if (heard.is_refusal) {
    onRefusal(reply, now);
  } else {
    onKind(reply, now);
  }
}

void OkPacedJob::onKind(const FirmwareReply& reply, double now) {
  switch (reply.kind) {
    case ReplyKind::Ok:
      onOk(now);
      break;
    case ReplyKind::Start:
      onRestart(reply, now);
      break;
    case ReplyKind::Fatal:
      onHalt(reply, now);
      break;
    case ReplyKind::NotDone:
      onNotDone(reply);
      break;
    case ReplyKind::Warning:
      record_.status.message = reply.text;
      break;
    case ReplyKind::Pause:
      record_.status.message = reply.text;
      if (pause(now)) is_paused_by_machine_ = true;
      break;
    case ReplyKind::Resume:
      if (std::exchange(is_paused_by_machine_, false)) resume(now);
      break;
    case ReplyKind::Cancel:
      fail(ErrorCode::Cancelled, "the machine ends the job: \"" + reply.text + "\"", now);
      break;
    default:
      break;
  }
}

void OkPacedJob::onOk(double now) {
  if (phase_ == Phase::Opening) {
    onOpeningOk(now);
  } else if (phase_ == Phase::Stopping && stop_.isAwaitingReason()) {
    onReason();
  } else if (phase_ == Phase::Locating) {
    if (questions_.answer()) return onLocated(now);
    questions_.hearOk();
  } else if (phase_ == Phase::Feeding) {
    if (const auto oldest = under_way_.takeOldest()) acknowledge(*oldest, now);
  }
}

void OkPacedJob::onAnswer(const SyncAnswer& answer, double now) {
  if (phase_ == Phase::Locating) {
    if (!questions_.hear(answer) || (isLossy() && !answer.position)) return;
    questions_.keep(answer);
    // An ok that was another's could be taken for that of this answer; nothing follows at the end.
    if (aim_ == Aim::End) onLocated(now);
  } else if (phase_ == Phase::Feeding) {
    if (!under_way_.hasQuestion(answer.question)) return;
    // Nothing is lost on the way: all before the question was read.
    while (!under_way_.isNext(answer.question)) acknowledge(*under_way_.takeOldest(), now);
  } else if (phase_ == Phase::Stopping && answer.question == questions_.last()) {
    onStopAnswer(now);
  }
}

void OkPacedJob::onRefusal(const FirmwareReply& reply, double now) {
  record_.status.message = reply.text;
  if (failsByHeater(reply, now)) return;
  // One that comes while nothing is under way is another sender's.
  if (record_.isStarting() || isStopping() || (under_way_.empty() && phase_ == Phase::Feeding)) return;
  const std::string change = phase_ == Phase::Feeding ? under_way_.changeNext() : std::string();
  if (!change.empty()) {
    record_.status.message = "change " + change + " was refused: \"" + reply.text + "\"";
    return;
  }
  const std::uint64_t line = under_way_.oldestLine();
  const std::string what = line == 0 || !feed_.rewind(line)
                               ? "a line"
                               : "line " + std::to_string(line) + ", " + quotation_.of(feed_.peek()->command);
  fail(ErrorCode::Rejected, "the machine did not run " + what + ": \"" + reply.text + "\"", now);
}

void OkPacedJob::onHalt(const FirmwareReply& reply, double now) {
  if (isStopping() && stop_.isAwaitingReason()) return;
  if (isStopping())
    return finishAborted("; the machine halted: \"" + reply.text + "\"; " + firmware_->afterHalt());
  if (record_.isStarting()) {
    abort({ErrorCode::Rejected, "the machine has halted: \"" + reply.text + "\""}, now);
    return;
  }
  record_.beginToStop(
      {ErrorCode::Rejected, "the machine halted: \"" + reply.text + "\"" + record_.whereItStands()});
  const std::string question = firmware_->reasonOfHalt();
  if (question.empty()) return finishAborted("; " + firmware_->afterHalt());
  prepareStop(now);
  stop_.awaitReason();
  beginPhase(Phase::Stopping, now);
  opening_answer_.clear();
  send(question, {});
}

void OkPacedJob::onReason() {
  const OpeningVerdict verdict = firmware_->judge(firmware_->reasonOfHalt(), opening_answer_);
  if (verdict.kind != OpeningVerdict::Kind::Refused) return;
  finishAborted("; " + verdict.why + "; " + firmware_->afterHalt());
}

void OkPacedJob::onRestart(const FirmwareReply& reply, double now) {
  if (record_.isStarting()) {
    step_ = 0;
    beginPhase(Phase::Opening, now);
    return askOpening(now);
  }
  const Failure why{ErrorCode::DeviceError,
                    "the machine was reset: \"" + reply.text + "\"" + record_.whereItStands()};
  const std::string known = firmware_->afterRestart();
  if (known.empty()) return abort(why, now);
  if (!isStopping()) record_.beginToStop(why);
  finishAborted("; " + known);
}

void OkPacedJob::onNotDone(const FirmwareReply& reply) {
  record_.status.message = reply.text;
  const bool is_change = !under_way_.changeNext().empty();
  if (!isStopping() && phase_ != Phase::Opening && !is_change) account_.notDone(reply.text);
}

}  // namespace lamina
