// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/grbl/grbl_job.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/duration_text.hpp"
#include "streaming/firmware/grbl/grbl_syntax.hpp"
#include "streaming/job/job_failures.hpp"

namespace lamina {
namespace {

constexpr double kNoDeadline = std::numeric_limits<double>::infinity();
constexpr double kJobPoll = 0.2;     // s; grbl's own recommendation is 5 to 10 Hz at most
constexpr double kChangePoll = 0.1;  // s
constexpr double kPlacePoll = 0.1;   // s; the work's offset is in one of thirty reports
constexpr int kUsualReceiveBytes = 128;
constexpr const char* kQuestion = "$G";
constexpr std::size_t kQuestionBytes = 3;
// Behind the head of a line that was cut off it is a word without number, for which grbl refuses the whole.
constexpr const char* kRefusedWord = "Z\n";

/// As the listeners of all firmware take it.
FirmwareReply translated(const GrblReply& reply) {
  FirmwareReply translation;
  translation.text = reply.text;
  if (reply.kind == GrblReplyKind::Ok) translation.kind = ReplyKind::Ok;
  if (reply.kind == GrblReplyKind::Error || reply.kind == GrblReplyKind::Alarm)
    translation.kind = ReplyKind::Fatal;
  if (reply.kind == GrblReplyKind::Greeting) translation.kind = ReplyKind::Start;
  return translation;
}

}  // namespace

GrblJob::GrblJob(StreamOrder order)
    : order_(std::move(order)),
      feed_(sourceOf(order_.program), 1),
      start_(order_.settings),
      answers_(order_.settings.probe_after_s) {
  record_.status.lines_total = order_.program.lines();
}

void GrblJob::start(double now) {
  if (state() != PackmlState::Idle) return;
  record_.enter(PackmlState::Starting);
  record_.status.firmware_name = order_.firmware_name.value_or("");
  phase_ = Phase::Starting;
  if (order_.unfinished) output_ += kRefusedWord;
  start_.begin(now);
}

void GrblJob::followStart(double now) {
  output_ += start_.takeOutput();
  if (start_.failure()) {
    abort(*start_.failure(), now);
  } else if (start_.isReady()) {
    const GrblMachine& machine = start_.machine();
    record_.status.firmware_name = machine.name();
    const int reported = machine.receive_bytes > 0 ? machine.receive_bytes : kUsualReceiveBytes;
    window_.setCapacity(static_cast<std::size_t>(std::min(reported, order_.settings.window_bytes)));
    expected_ = ExpectedPosition(machine.modes);
    beginChecking(now);
  }
}

void GrblJob::beginChecking(double now) {
  phase_ = Phase::Checking;
  try {
    check_.emplace(order_.program, start_.machine());
  } catch (const Error&) {
    abort(currentFailure(), now);
  }
}

void GrblJob::check(double now) {
  check_->checkMoreLines();
  record_.status.warning = check_->warning();
  if (!check_->defect().empty()) {
    abort({ErrorCode::InvalidProgram, check_->defect()}, now);
  } else if (check_->isDone()) {
    order_.unfinished ? beginLocating(now) : execute(now);
  }
}

void GrblJob::beginLocating(double now) {
  phase_ = Phase::Locating;
  // grbl reports Idle in a dwell too: what was reported before its questions were answered is where it stood
  // between two lines.
  place_.forgetWork();
  heard_s_ = now;
  next_poll_s_ = now;
  locate_by_s_ = now + order_.settings.connect_timeout_s;
  continueOncePlaced(now);
}

/// Continues the job at the position of the machine once the machine is idle and has reported that position
/// in coordinates of the work. Asks for it again until then, and aborts after the timeout.
void GrblJob::continueOncePlaced(double now) {
  const bool is_idle = machine_state_ == GrblState::Idle;
  if (place_.work() && is_idle) return continueAt(*place_.work(), now);
  if (now < locate_by_s_) {
    next_poll_s_ = now + kPlacePoll;
    output_ += grbl_byte::kStatus;
  } else if (place_.work()) {
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

void GrblJob::continueAt(const GrblAxes& work, double now) {
  const GrblMachine& machine = start_.machine();
  const auto passed = [this](const ProgramLine& line) { record_.status.layer = line.layer; };
  try {
    const GrblResumption found =
        resumptionOf(order_.program, *order_.unfinished, machine.modes, machine.inMillimetres(work));
    if (!found.refusal.empty()) return abort({ErrorCode::Rejected, found.refusal}, now);
    expected_ = found.expected;
    record_.status.lines_acknowledged = record_.status.lines_sent = found.line;
    auto rest = restOf(order_.program, found.line, passed);  // states the layer
    feed_ = LineFeed(std::move(rest), found.line + 1, record_.status.layer);
  } catch (const Error&) {
    return abort(currentFailure(), now);
  }
  execute(now);
}

void GrblJob::execute(double now) {
  check_.reset();
  has_begun_ = true;
  record_.enter(PackmlState::Execute);
  phase_ = Phase::Feeding;
  heard_s_ = next_poll_s_ = now;
  answers_.restart(now);
  proceed(now);
}

/// Sends what may be sent, and takes the step that is due when nothing is under way any more.
void GrblJob::proceed(double now) {
  if (phase_ != Phase::Feeding || state() != PackmlState::Execute) return;
  pump(now);
  if (window_.empty() && feed_.peek() == nullptr) prove(now);
}

void GrblJob::pump(double now) {
  while (const ProgramLine* line = feed_.peek()) {
    if (isHeldBack(*line, now)) break;
    // A question must find room behind a full window.
    const std::size_t kept_free = window_.hasQuestion() ? 0 : kQuestionBytes;
    if (!window_.hasRoom(line->command.size() + 1 + kept_free)) break;
    if (window_.empty()) answers_.restart(now);
    window_.add({feed_.next(), line->command});
    expected_.follow(line->command);
    output_ += line->command;
    output_ += '\n';
    feed_.advance();
  }
  record_.status.lines_sent = feed_.end() - 1;
}

/// A question whose answer differs from that to a line of the program: as answers come in order, all
/// lines before it were answered then.
void GrblJob::ask() {
  ++record_.status.probes;
  window_.add({0, kQuestion});
  output_ += std::string(kQuestion) + "\n";
}

void GrblJob::prove(double now) {
  if (const auto why = shortfall(feed_.end() - 1, record_)) return abort(*why, now);
  phase_ = Phase::Proving;
  answers_.restart(now);
  ask();
}

// Time.

double GrblJob::silenceLimit() const { return heard_s_ + order_.settings.silence_timeout_s; }

bool GrblJob::isAnswerDue() const {
  const bool may_run = state() == PackmlState::Execute || state() == PackmlState::Completing;
  return may_run && !window_.empty();
}

/// While the machine waits as the program says, a line may take long. One that moves restarts the time.
double GrblJob::answerLimit() const {
  if (!isAnswerDue()) return kNoDeadline;
  const bool may_take_long = mayStandStill(window_.front().command);
  return answers_.quietSince() +
         (may_take_long ? order_.settings.blocking_timeout_s : order_.settings.silence_timeout_s);
}

double GrblJob::nextDeadline() const {
  switch (phase_) {
    case Phase::Idle:
      return kNoDeadline;
    case Phase::Offline:
      return safe_stop_by_s_;
    case Phase::Starting:
      return start_.nextDeadline();
    case Phase::Checking:
      return heard_s_;
    case Phase::Locating:
      return next_poll_s_;
    case Phase::Stopping:
      return std::min(stop_->nextDeadline(), safe_stop_by_s_);
    default:
      break;
  }
  const double probe = isAnswerDue() ? answers_.retryAt() : kNoDeadline;
  return std::min({next_poll_s_, silenceLimit(), answerLimit(), probe});
}

void GrblJob::elapse(double now) {
  if (phase_ == Phase::Starting) {
    start_.elapse(now);
    followStart(now);
  } else if (phase_ == Phase::Checking) {
    check(now);
  } else if (phase_ == Phase::Locating) {
    if (now >= next_poll_s_) continueOncePlaced(now);
  } else if (phase_ == Phase::Stopping || phase_ == Phase::Offline) {
    followStop(now);
  } else if (isRunning()) {
    if (now >= next_poll_s_) poll(now);
    if (now >= silenceLimit()) {
      abort({ErrorCode::TimedOut, "no answer from the machine for " + fullTenths(now - heard_s_) +
                                      "; expected one to each '?'" + record_.whereItStands()},
            now);
    } else if (now >= answerLimit()) {
      loseCount("the machine has neither moved nor answered a line for " + fullTenths(answers_.quietFor(now)),
                now);
    } else if (isAnswerDue() && now >= answers_.retryAt()) {
      onNoAnswer(now);
    }
  }
}

void GrblJob::onNoAnswer(double now) {
  answers_.asked(now);
  // A machine in motion only waits for room in its queue.
  if (machine_state_ == GrblState::Idle && window_.hasRoom(kQuestionBytes)) ask();
}

void GrblJob::poll(double now) {
  const int wanted = order_.settings.position_interval_s;
  const bool is_feeding = state() == PackmlState::Execute && wanted > 0;
  next_poll_s_ = now + (is_feeding ? static_cast<double>(wanted) : kJobPoll);
  if (overrides_.isUnderWay() || is_at_layer_) next_poll_s_ = now + kChangePoll;
  if (state() == PackmlState::Holding && is_held_by_user_) output_ += grbl_byte::kFeedHold;
  if (state() == PackmlState::Unholding && machine_state_ == GrblState::Hold && now >= release_again_s_)
    release(now);
  output_ += grbl_byte::kStatus;
}

// What the machine says.

std::string GrblJob::takeOutput() { return std::exchange(output_, {}); }

void GrblJob::receive(std::string_view bytes, double now) {
  replies_.add(bytes);
  while (const auto line = replies_.next()) {
    const GrblReply reply = parseGrblReply(*line);
    if (order_.heard) order_.heard(translated(reply));
    onReply(reply, now);
  }
  proceed(now);
}

void GrblJob::onReply(const GrblReply& reply, double now) {
  if (phase_ == Phase::Idle || phase_ == Phase::Offline) return;
  if (reply.kind != GrblReplyKind::Other) heard_s_ = now;
  if (phase_ == Phase::Stopping) {
    stop_->hear(reply, now);
    return followStop(now);
  }
  if (phase_ == Phase::Starting && order_.unfinished && reply.kind == GrblReplyKind::Greeting) {
    abort(
        {ErrorCode::Rejected,
         "the machine was reset, as by opening its port, and has forgotten where it was: there is no job to "
         "go on with; lamina resume makes a program of the rest"},
        now);
    return;
  }
  if (phase_ == Phase::Starting) {
    start_.hear(reply, now);
    if (reply.report) place_.learn(*reply.report);
    if (reply.report && reply.report->overrides) overrides_.hear(*reply.report->overrides, now);
    return followStart(now);
  }
  switch (reply.kind) {
    case GrblReplyKind::Ok:
      return onOk(now);
    case GrblReplyKind::Error:
      return onError(reply.code, now);
    case GrblReplyKind::Alarm:
      return onAlarm(reply.text, reply.code, now);
    case GrblReplyKind::Greeting:
      return abort({ErrorCode::DeviceError, "the machine was reset" + record_.whereItStands()}, now);
    case GrblReplyKind::Report:
      return onReport(*reply.report, now);
    case GrblReplyKind::Modes:
      return onModes(now);
    case GrblReplyKind::Message:
      record_.status.message = reply.text;
      return;
    default:
      return;
  }
}

void GrblJob::onAnswered(double now) {
  answers_.restart(now);
  if (state() == PackmlState::Unholding) onMoving(now);
}

void GrblJob::onOk(double now) {
  const std::string trouble = window_.hearOk();
  if (!trouble.empty()) return loseCount(trouble, now);
  onAnswered(now);
  const GrblWindow::Line line = window_.take();
  if (line.number > 0) {
    record_.status.lines_acknowledged = line.number;
    record_.status.layer = feed_.layerOf(line.number);
  } else if (phase_ == Phase::Proving) {
    phase_ = Phase::Resting;
    standstill_.restart();
    record_.enter(PackmlState::Completing);
    poll(now);
  }
}

void GrblJob::onModes(double now) {
  const std::string trouble = window_.hearAnswer();
  if (!trouble.empty()) loseCount(trouble, now);
}

/// Whatever the code: a motion, a spindle or a coordinate system that was asked for is missing, and grbl goes
/// on with the lines behind.
void GrblJob::onError(int code, double now) {
  const std::string why =
      "error:" + std::to_string(code) + ", " + meaningOfGrblError(code, start_.machine().dialect);
  const std::string what = window_.empty() || window_.front().number == 0
                               ? std::string("something that is no line of the program")
                               : "line " + std::to_string(window_.front().number) + " " +
                                     order_.program.quotation().of(window_.front().command);
  abort({ErrorCode::Rejected, "the machine refused " + what + " (" + why + ")" + record_.whereItStands()},
        now);
}

void GrblJob::onAlarm(const std::string& code_text, int code, double now) {
  const std::string why = code > 0 ? ", " + meaningOfGrblAlarm(code, start_.machine().dialect) : "";
  record_.beginToStop({ErrorCode::Rejected, "the machine has locked itself: \"" + code_text + "\"" + why +
                                                record_.whereItStands()});
  if (!has_begun_) return finishAborted("");
  stop(GrblStop::Motion::EndedByAlarm, now);
}

/// An answer was lost, or a line: which of the two nobody knows.
void GrblJob::loseCount(const std::string& what, double now) {
  abort({ErrorCode::DeviceError, what + "; " + std::to_string(window_.count()) +
                                     " lines are under way, and it is in doubt which of them were run" +
                                     record_.whereItStands()},
        now);
}

void GrblJob::onReport(const GrblReport& report, double now) {
  machine_state_ = report.state;
  machine_substate_ = report.substate.value_or(0);
  if (place_.follow(report)) answers_.restart(now);
  if (place_.work()) {
    const GrblAxes work = start_.machine().inMillimetres(*place_.work());
    record_.status.position = ReportedPosition{work[0], work[1], work[2], 0.0};
  }
  switch (report.state) {
    case GrblState::Alarm:
      return onAlarm(report.state_text, machine_substate_, now);
    case GrblState::Check:
    case GrblState::Sleep:
      return abort({ErrorCode::Rejected, "the machine went into state " + report.state_text +
                                             "; expected it to run the program" + record_.whereItStands()},
                   now);
    default:
      break;
  }
  if (!isRunning()) return;
  followOverrides(report, now);
  countStarvation(report, now);
  onMotionState(report, now);
  holdAtLayer(report, now);
  const bool is_idle = report.state == GrblState::Idle;
  if (phase_ == Phase::Resting && is_idle && standstill_.isCertainAt(now)) finish(now);
}

void GrblJob::countStarvation(const GrblReport& report, double now) {
  const bool are_lines_due = phase_ == Phase::Feeding && state() == PackmlState::Execute && !is_at_layer_ &&
                             record_.status.lines_acknowledged > 0;
  if (!are_lines_due) return starvation_.end();
  starvation_.see(report, start_.machine().blocks, record_.status.lines_acknowledged + 1, now);
  record_.status.starvation = starvation_.starvation();
}

/// Holds of the machine's own are obeyed: a button, a door, M0, a tool that is to be changed.
void GrblJob::onMotionState(const GrblReport& report, double now) {
  const bool is_held =
      report.state == GrblState::Hold || report.state == GrblState::Door || report.state == GrblState::Tool;
  if (report.state != GrblState::Idle) standstill_.restart();
  if (is_held && state() == PackmlState::Execute) {
    record_.status.message = "the machine holds: " + report.state_text;
    record_.enter(PackmlState::Holding);
  }
  const bool is_slowing = (report.state == GrblState::Hold && machine_substate_ > 0) ||
                          (report.state == GrblState::Door && machine_substate_ > 1);
  if (is_held && !is_slowing) return onStandstill(now);
  if (is_held) return;
  if (report.state == GrblState::Idle && state() == PackmlState::Holding) {
    // Nothing was left to be held.
    if (standstill_.isCertainAt(now)) onStandstill(now);
  } else if (state() == PackmlState::Unholding ||
             (state() == PackmlState::Held && (!is_held_by_user_ || report.state != GrblState::Idle))) {
    onMoving(now);
  }
}

void GrblJob::onStandstill(double now) {
  if (state() != PackmlState::Holding) return;
  record_.enter(PackmlState::Held);
  if (std::exchange(is_resume_wanted_, false)) resume(now);
}

/// Also where a person at the machine has released it.
void GrblJob::onMoving(double now) {
  if (state() == PackmlState::Held) record_.enter(PackmlState::Unholding);
  record_.enter(PackmlState::Execute);
  is_held_by_user_ = false;
  answers_.restart(now);
}

void GrblJob::finish(double now) {
  const GrblMachine& machine = start_.machine();
  if (place_.work() && machine.reports_in_inches) {
    const std::string contradiction = expected_.contradictionBy(machine.inMillimetres(*place_.work()));
    if (!contradiction.empty()) {
      abort({ErrorCode::DeviceError,
             "all lines were answered, but the machine does not stand where they end: " + contradiction +
                 "; lines were lost or damaged"},
            now);
      return;
    }
  }
  phase_ = Phase::Idle;
  record_.enter(PackmlState::Complete);
}

// Pause, abort and the link.

bool GrblJob::pause(double now) {
  const LayerPause::Wish wish = layer_pause_.pauseNow(record_);
  if (wish != LayerPause::Wish::Begun) return wish == LayerPause::Wish::Kept;
  is_at_layer_ = false;
  is_held_by_user_ = true;
  is_resume_wanted_ = false;
  standstill_.restart();
  poll(now);
  return true;
}

bool GrblJob::resume(double now) {
  if (layer_pause_.takeBack(record_)) return true;
  if (state() == PackmlState::Holding) {
    is_resume_wanted_ = true;  // grbl ignores it before it is at rest
    return true;
  }
  if (state() != PackmlState::Held) return false;
  if (machine_state_ == GrblState::Door && machine_substate_ != 0) return false;
  record_.enter(PackmlState::Unholding);
  release(now);
  poll(now);
  return true;
}

/// Overrides are made of bytes that need no room in the buffer.
std::string GrblJob::change(const LiveChange& change, double now) {
  if (!record_.isUnderWay() || !isRunning()) return kNoJobToChange;
  if (layer_pause_.take(change)) return {};
  std::string refusal = overrides_.set(change, now);
  if (refusal.empty()) poll(now);
  return refusal;
}

void GrblJob::followOverrides(const GrblReport& report, double now) {
  if (report.overrides) overrides_.hear(*report.overrides, now);
  if (!overrides_.isUnderWay()) return;
  output_ += overrides_.takeBytes();
  const std::string remark = overrides_.giveUp(now);
  if (!remark.empty()) record_.status.message = remark;
}

/// In front of the layer at which a person wants to hold: the lines before it are run to their end first.
bool GrblJob::isHeldBack(const ProgramLine& line, double now) {
  if (!is_at_layer_ && layer_pause_.takeIfDueAt(line.layer)) {
    is_at_layer_ = true;
    standstill_.restart();
    next_poll_s_ = now;
    if (line.layer >= 0) record_.status.message = "holds in front of layer " + std::to_string(line.layer);
  }
  return is_at_layer_;
}

/// The hold comes when the last motion has ended, so that it stands between two layers and a laser in laser
/// mode goes off.
void GrblJob::holdAtLayer(const GrblReport& report, double now) {
  const bool is_still =
      is_at_layer_ && state() == PackmlState::Execute && window_.empty() && report.state == GrblState::Idle;
  if (!is_still || !standstill_.isCertainAt(now)) return;
  is_at_layer_ = false;
  pause(now);
}

void GrblJob::release(double now) {
  output_ += grbl_byte::kCycleStart;
  release_again_s_ = now + order_.settings.probe_after_s;
}

void GrblJob::abort(const Failure& why, double now) {
  if (record_.isStopping() || isFinal(state())) return;
  record_.beginToStop(why);
  if (!has_begun_) return finishAborted("");
  stop(GrblStop::Motion::Possible, now);
}

void GrblJob::stop(GrblStop::Motion motion, double now) {
  safe_stop_by_s_ = now + order_.settings.safe_stop_timeout_s;
  window_.clear();
  stop_.emplace(motion, order_.settings.safe_stop_timeout_s, now);
  phase_ = Phase::Stopping;
  output_ += stop_->takeOutput();
}

void GrblJob::followStop(double now) {
  if (phase_ == Phase::Offline) {
    if (now >= safe_stop_by_s_) finishAborted(kLinkNotBack);
    return;
  }
  stop_->elapse(now);
  output_ += stop_->takeOutput();
  if (stop_->isConfirmed()) {
    finishAborted(stop_->remark());
  } else if (now >= safe_stop_by_s_) {
    finishAborted(stop_->remark() + "; the machine did not confirm the safe stop");
  }
}

/// A machine whose link is lost runs on what its buffer holds, and its spindle turns on.
void GrblJob::disconnect(const std::string& why, double now) {
  if (isFinal(state()) || phase_ == Phase::Offline) return;
  if (!record_.isStopping()) {
    record_.beginToStop({ErrorCode::Disconnected, why + record_.whereItStands()});
    if (!has_begun_) return finishAborted("");
    safe_stop_by_s_ = now + order_.settings.safe_stop_timeout_s;
  }
  window_.clear();
  replies_.clear();
  output_.clear();
  phase_ = Phase::Offline;
}

void GrblJob::reconnect(double now) {
  if (phase_ == Phase::Offline) stop(GrblStop::Motion::Possible, now);
}

void GrblJob::finishAborted(const std::string& remark) {
  record_.status.failure.message += remark;
  phase_ = Phase::Idle;
  window_.clear();
  record_.enter(PackmlState::Aborted);
}

}  // namespace lamina
