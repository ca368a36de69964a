// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/ok_paced/ok_paced_job.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/duration_text.hpp"

namespace lamina {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();
constexpr const char* kEndOfMotions = "M400";
constexpr const char* kTemperatures = "M105";
constexpr const char* kPosition = "M114";

}  // namespace

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
      program_(revised_ ? [revised = revised_] { return revised->next(); } : sourceOf(order.program)),
      quotation_(order.program.quotation()),
      feed_([this] { return nextLine(); }, 1, -1, [this] { return isNextKnown(); }),
      timer_(order.settings.probe_after_s),
      opening_(firmware_->opening(order.settings.link)) {
  // Such firmware runs what it has read behind a line that it refuses.
  if (settings_.window_lines == 0) settings_.window_lines = 1;
  if (isLossy()) settings_.window_lines = 1;
  record_.status.lines_total = order.program.lines();
  if (order.firmware_name) record_.status.firmware_name = *order.firmware_name;
}

/// The lines of the program, and the wait for the end of their motions: behind the last one, and in front of
/// a layer that is not known yet.
std::optional<ProgramLine> OkPacedJob::nextLine() {
  if (revised_ && !revised_->isNextKnown()) {
    is_rest_given_ = true;
    ++rests_;
    ++lines_read_;
    return ProgramLine{kEndOfMotions, layer_given_};
  }
  auto line = program_();
  countLines();
  if (line) {
    is_rest_given_ = false;
    layer_given_ = line->layer;
    ++lines_read_;
    return line;
  }
  if (lines_read_ != record_.status.lines_total) return std::nullopt;
  ++lines_read_;
  return ProgramLine{kEndOfMotions, -1};
}

bool OkPacedJob::isNextKnown() { return !revised_ || !is_rest_given_ || revised_->isNextKnown(); }

/// Lines that are revised become more or fewer, and the waits for the end of motions are lines, too.
void OkPacedJob::countLines() {
  if (revised_) record_.status.lines_total = revised_->total() + rests_;
}

void OkPacedJob::beginPhase(Phase phase, double now) {
  phase_ = phase;
  questions_ = 0;
  oks_heard_ = 0;
  is_ok_heard_ = false;
  answer_.reset();
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
  if (!isWaiting()) return kForever;
  if (phase_ == Phase::Offline) return stop_.give_up_s;
  if (isAwaitingLayer()) return next_look_;
  const double give_up = isStopping() ? stop_.give_up_s : timer_.quietSince() + silenceLimit();
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
bool OkPacedJob::leavesRoomForStop() const { return hasRoomFor(1 + stopCommands().size() + 1); }

std::uint64_t OkPacedJob::ask() {
  ++questions_;
  ++last_question_;
  PacedCommand as;
  as.question = last_question_;
  send(firmware_->question(last_question_, settings_.link), as);
  unanswered_.isQuestion(last_question_);
  return last_question_;
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

/// Asks until the last question is answered: then everything before it is answered too, or never will be.
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
  if (answer_ && answer_->position) tracker_.locate(*answer_->position);
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
  const auto line = under_way_.takeOldest();
  RunEvidence evidence = RunEvidence::None;
  if (answer_->position) evidence = tracker_.evidence(*answer_->position);
  if (is_ok_heard_) evidence = RunEvidence::Ran;
  if (evidence == RunEvidence::None && tracker_.isRepeatable()) evidence = RunEvidence::DidNotRun;
  const auto position = answer_->position;
  under_way_.clear();
  beginPhase(Phase::Feeding, now);
  if (evidence == RunEvidence::None) {
    feed_.rewind(line->line);
    abort({ErrorCode::DeviceError,
           "it is not known whether the machine ran line " + std::to_string(line->line) + ", " +
               quotation_.of(feed_.peek()->command) + ", whose ok did not come; it was not sent again" +
               record_.whereItStands()},
          now);
    return;
  }
  if (evidence == RunEvidence::Ran) {
    acknowledge(*line, now);
  } else {
    ++record_.status.resends;
    undone_.rewind(line->line);
    feed_.rewind(line->line);
  }
  if (position) tracker_.locate(*position);
}

void OkPacedJob::acknowledge(const PacedCommand& command, double now) {
  if (command.line == 0) return;
  tracker_.confirm();
  if (command.line > record_.status.lines_total) return;
  undone_.acknowledge(command.line);
  record_.status.commands_not_done = undone_.count();
  starvation_.acknowledged(command.line, std::nullopt, now);
  record_.status.starvation = starvation_.starvation();
  record_.status.lines_acknowledged = command.line;
  record_.status.layer = feed_.layerOf(command.line);
}

/// Sends what may be sent, and takes the step that is due when nothing is under way any more.
void OkPacedJob::proceed(double now) {
  if (phase_ != Phase::Feeding) return;
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
  constexpr double kLookInterval = 0.01;  // s
  starvation_.standStill();
  if (layer_due_ == 0.0) layer_due_ = now + revised_->waitTime();
  next_look_ = now + kLookInterval;
}

void OkPacedJob::onAllTaken(double now) {
  if (revised_ && revised_->failure().code != ErrorCode::Ok)
    return abort({revised_->failure().code, revised_->failure().message + record_.whereItStands()}, now);
  if (lines_read_ <= record_.status.lines_total) {
    abort({ErrorCode::InvalidProgram, "the program was changed while it was streamed: it ended after line " +
                                          std::to_string(lines_read_) + " of " +
                                          std::to_string(record_.status.lines_total)},
          now);
    return;
  }
  locate(Aim::End, now);
}

void OkPacedJob::pump(double now) {
  while (phase_ == Phase::Feeding && sendNext(now)) {
  }
  countLines();
  record_.status.lines_sent = std::min(feed_.end() - 1, record_.status.lines_total);
}

/// @return whether a line was sent
bool OkPacedJob::sendNext(double now) {
  const ProgramLine* line = feed_.isNextKnown() ? feed_.peek() : nullptr;
  if (line == nullptr) return false;
  layer_due_ = 0.0;
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
    starvation_.sentWait(as.line, now);
  else
    starvation_.sent(as.line, line->seconds, now);
  feed_.advance();
  send(command, as);
  return true;
}

/// Asks for the temperatures and the position, where an ok more or less is no matter.
void OkPacedJob::poll(double now) {
  if (isLossy() || now < next_poll_ || under_way_.hasOthers()) return;
  const auto least = [](int a, int b) { return a == 0 || b == 0 ? std::max(a, b) : std::min(a, b); };
  const int interval_s = least(settings_.temperature_interval_s, settings_.position_interval_s);
  if (interval_s == 0) return;
  next_poll_ = now + interval_s;
  if (settings_.temperature_interval_s > 0) send(kTemperatures, {});
  if (settings_.position_interval_s > 0) send(kPosition, {});
}

void OkPacedJob::elapse(double now) {
  if (!isWaiting()) return;
  if (isAwaitingLayer()) {
    if (now >= layer_due_) revised_->decide();
    return proceed(now);
  }
  if (isStopping() && now >= stop_.give_up_s) {
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
      answer_.reset();
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
    abort({ErrorCode::TimedOut,
           "no answer from the machine for " + wholeSeconds(timer_.quietFor(now)) + record_.whereItStands()},
          now);
  } else if (!not_yet_.empty()) {
    abort({ErrorCode::Rejected, not_yet_}, now);
  } else if (has_answered_) {
    abort({ErrorCode::Rejected,
           "the machine answers, but not to \"" +
               (phase_ == Phase::Opening ? opening_[step_]
                                         : firmware_->question(last_question_, settings_.link)) +
               "\" as " + settings_.firmware + " does"},
          now);
  } else {
    abort({ErrorCode::TimedOut, "no machine answered within " + wholeSeconds(settings_.connect_timeout_s) +
                                    "; is it on, and is the baud rate right?"},
          now);
  }
}

bool OkPacedJob::pause(double now) {
  const LayerPause::Wish wish = layer_pause_.pauseNow(record_);
  if (wish != LayerPause::Wish::Begun) return wish == LayerPause::Wish::Kept;
  starvation_.standStill();
  proceed(now);
  return true;
}

bool OkPacedJob::resume(double now) {
  if (layer_pause_.takeBack(record_)) return true;
  if (record_.status.state != PackmlState::Held && record_.status.state != PackmlState::Holding) return false;
  layer_due_ = 0.0;  // the time to wait for a layer begins anew
  is_paused_by_machine_ = false;
  if (record_.status.state == PackmlState::Holding) record_.enter(PackmlState::Held);
  record_.enter(PackmlState::Unholding);
  record_.enter(PackmlState::Execute);
  proceed(now);
  return true;
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
  if (heard.are_heaters_off) {
    stop_.are_heaters_off = heard.are_heaters_off;
    temperatures_ = reply.text;
  }
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
      if (is_paused_by_machine_) resume(now);
      break;
    case ReplyKind::Cancel:
      abort({ErrorCode::Cancelled,
             "the machine ends the job: \"" + reply.text + "\"" + record_.whereItStands()},
            now);
      break;
    default:
      break;
  }
}

void OkPacedJob::onOk(double now) {
  if (phase_ == Phase::Opening) {
    onOpeningOk(now);
  } else if (phase_ == Phase::Stopping && stop_.stage == StopStage::Reason) {
    onReason();
  } else if (phase_ == Phase::Locating) {
    if (answer_) return onLocated(now);
    ++oks_heard_;
  } else if (phase_ == Phase::Feeding) {
    if (const auto oldest = under_way_.takeOldest()) acknowledge(*oldest, now);
  }
}

void OkPacedJob::onAnswer(const SyncAnswer& answer, double now) {
  if (phase_ == Phase::Locating) {
    // The questions before this one have no more oks than they are; one more is that of the line.
    const std::uint64_t first = last_question_ - static_cast<std::uint64_t>(questions_) + 1;
    if (answer.question >= first && oks_heard_ > answer.question - first) is_ok_heard_ = true;
    if (answer.question != last_question_) return;
    if (isLossy() && !answer.position) return;
    answer_ = answer;
    // An ok that was another's could be taken for that of this answer; nothing follows at the end.
    if (aim_ == Aim::End) onLocated(now);
  } else if (phase_ == Phase::Feeding) {
    if (!under_way_.hasQuestion(answer.question)) return;
    // Nothing is lost on the way: all before the question was read.
    while (!under_way_.isNext(answer.question)) acknowledge(*under_way_.takeOldest(), now);
  } else if (phase_ == Phase::Stopping && answer.question == last_question_) {
    onStopAnswer(now);
  }
}

void OkPacedJob::onRefusal(const FirmwareReply& reply, double now) {
  record_.status.message = reply.text;
  // One that comes while nothing is under way is another sender's.
  if (record_.isStarting() || isStopping() || (under_way_.empty() && phase_ == Phase::Feeding)) return;
  const std::uint64_t line = under_way_.oldestLine();
  if (line == 0 || !feed_.rewind(line)) {
    abort({ErrorCode::Rejected,
           "the machine did not run a line: \"" + reply.text + "\"" + record_.whereItStands()},
          now);
    return;
  }
  abort({ErrorCode::Rejected, "the machine did not run line " + std::to_string(line) + ", " +
                                  quotation_.of(feed_.peek()->command) + ": \"" + reply.text + "\"" +
                                  record_.whereItStands()},
        now);
}

void OkPacedJob::onHalt(const FirmwareReply& reply, double now) {
  if (isStopping() && stop_.stage == StopStage::Reason) return;
  if (isStopping())
    return finishAborted("; the machine halted: \"" + reply.text + "\"; " + firmware_->afterHalt());
  if (record_.isStarting()) {
    abort({ErrorCode::Rejected, "the machine has halted: \"" + reply.text + "\""}, now);
    return;
  }
  record_.status.failure = {ErrorCode::Rejected,
                            "the machine halted: \"" + reply.text + "\"" + record_.whereItStands()};
  record_.enter(PackmlState::Aborting);
  const std::string question = firmware_->reasonOfHalt();
  if (question.empty()) return finishAborted("; " + firmware_->afterHalt());
  prepareStop(now);
  stop_.stage = StopStage::Reason;
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
  if (!isStopping()) {
    record_.status.failure = why;
    record_.enter(PackmlState::Aborting);
  }
  finishAborted("; " + known);
}

void OkPacedJob::onNotDone(const FirmwareReply& reply) {
  record_.status.message = reply.text;
  if (isStopping() || phase_ == Phase::Opening) return;
  if (undone_.count() == 0) record_.status.first_not_done = reply.text;
  undone_.announce();
}

}  // namespace lamina
