// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/client/streamer_machine.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace lamina {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr int kReportAttempts = 3;
// Lines under way when a job is aborted must not be taken for those of the safe stop.
constexpr std::uint64_t kSafeStopGap = 1000;

std::vector<std::string> reportRequests(const StreamSettings& settings, const FirmwareProtocol& firmware) {
  std::vector<std::string> requests;
  if (settings.position_interval_s > 0)
    requests.push_back(firmware.reportPosition(settings.position_interval_s));
  if (settings.temperature_interval_s > 0)
    requests.push_back(firmware.reportTemperatures(settings.temperature_interval_s));
  return requests;
}

std::string seconds(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find('.') + 2);
  return text + " s";
}

// A line that is refused this often without any progress will never be taken.
constexpr int kMostRefusals = 100;
constexpr int kMostOddRequests = 5;

}  // namespace

Streamer::Machine::Machine(const StreamableProgram& program, const StreamSettings& settings,
                           ReplyListener heard)
    : settings_(settings), feed_(sourceOf(program), 1), timer_(settings.probe_after_s) {
  validate(settings);
  settings_.window_lines = windowLines(settings, settings.link);
  firmware_ = firmwareProtocols().find(settings.firmware);
  heard_ = std::move(heard);
  status_.lines_total = program.lines();
  reports_ = reportRequests(settings, *firmware_);
}

void Streamer::Machine::enter(PackmlState state) {
  status_.state = state;
  entered_.push_back(state);
}

void Streamer::Machine::beginPhase(Phase phase, double now) {
  phase_ = phase;
  timer_.restart(now);
}

bool Streamer::Machine::isWaiting() const {
  if (phase_ == Phase::Feeding) return !sent_.empty() || isSettling();
  return phase_ != Phase::Idle;
}

double Streamer::Machine::silenceLimit() const {
  if (status_.state == PackmlState::Starting) return settings_.connect_timeout_s;
  const bool is_blocked = phase_ == Phase::Draining || sent_.hasBlocking();
  return is_blocked ? settings_.blocking_timeout_s : settings_.silence_timeout_s;
}

double Streamer::Machine::nextDeadline() const {
  if (!isWaiting()) return kNever;
  if (phase_ == Phase::Offline) return safe_stop_by_;
  const double give_up = isStopping() ? safe_stop_by_ : timer_.quietSince() + silenceLimit();
  const double deadline = std::min(timer_.retryAt(), give_up);
  return isSettling() ? std::min(deadline, settle_until_) : deadline;
}

void Streamer::Machine::start(double now) {
  if (status_.state != PackmlState::Idle) return;
  enter(PackmlState::Starting);
  identify(now);
}

/// Asks once more where a request contradicts what is known, and ends the job if it is repeated.
/// @return whether the request must not be followed
bool Streamer::Machine::isRefuted(std::uint64_t wanted, double now) {
  if (isStopping() || !proof_.contradicts(wanted, status_.lines_acknowledged)) {
    is_asking_again_ = false;
    return false;
  }
  if (!std::exchange(is_asking_again_, true)) {
    sent_.clear();
    settle_until_ = 0.0;
    beginPhase(Phase::Probing, now);
    probe(now);
    return true;
  }
  abort({ErrorCode::DeviceError, "the machine asks for line " + std::to_string(wanted) +
                                     ", which it has taken before: it was reset" + whereItStands()},
        now);
  return true;
}

void Streamer::Machine::beginNumbering(std::uint64_t base, double now) {
  base_ = base;
  beginPhase(Phase::Numbering, now);
  retry(now);
}

void Streamer::Machine::nextReport(double now) {
  if (!reports_.empty()) {
    beginPhase(Phase::Reporting, now);
    output_ += reports_.back() + "\n";
    return;
  }
  has_begun_ = true;
  enter(PackmlState::Execute);
  beginPhase(Phase::Feeding, now);
  awaitProbes(now);
  proceed(now);
}

/// Sends what may be sent, and takes the step that is due when nothing is under way any more.
void Streamer::Machine::proceed(double now) {
  settle(now);
  if (isSettling()) return;
  if (status_.state == PackmlState::Execute || isStopping()) pump(now);
  if (!sent_.empty()) return;
  if (status_.state == PackmlState::Holding) {
    enter(PackmlState::Held);
  } else if (status_.state == PackmlState::Execute || isStopping()) {
    // Nothing is left to send either: the machine must report that it has all.
    beginPhase(Phase::Probing, now);
    probe(now);
  }
}

bool Streamer::Machine::hasRoom(std::size_t bytes) const {
  if (sent_.empty() || must_send_one_) return true;
  return sent_.count() < static_cast<std::size_t>(settings_.window_lines) &&
         sent_.bytes() + bytes <= static_cast<std::size_t>(settings_.window_bytes);
}

void Streamer::Machine::pump(double now) {
  while (const ProgramLine* line = feed_.peek()) {
    const std::string framed = firmware_->framed(feed_.next(), line->command);
    if (!hasRoom(framed.size())) break;
    if (sent_.empty()) timer_.restart(now);
    must_send_one_ = false;
    sent_.add({feed_.next(), framed.size(), firmware_->isBlocking(line->command), feed_.next() < feed_.end(),
               false});
    output_ += framed;
    feed_.advance();
  }
  if (!isStopping()) status_.lines_sent = feed_.end() - 1;
}

/// Sends a line that the firmware must refuse, naming the line it waits for: a harmless one, with the number
/// after the next one.
void Streamer::Machine::probe(double) {
  ++status_.probes;
  ++unanswered_probes_;
  const std::uint64_t expected = phase_ == Phase::Numbering ? base_ + 1 : feed_.end();
  output_ += firmware_->framed(expected + 1, firmware_->harmless());
}

void Streamer::Machine::onProbeAnswer(std::uint64_t wanted, double now) {
  if (!goTo(wanted, now)) return;
  // The firmware has read everything that was sent before the probe.
  sent_.clear();
  awaitProbes(now);
  must_send_one_ = false;
  if (wanted < feed_.end()) ++status_.resends;
  beginPhase(Phase::Feeding, now);
  const bool may_feed = status_.state == PackmlState::Execute || isStopping();
  if (may_feed && feed_.peek() == nullptr) onAllTaken(now);
}

void Streamer::Machine::onAllTaken(double now) {
  const std::uint64_t lines_read = feed_.end() - 1;
  if (!isStopping() && lines_read < status_.lines_total) {
    abort({ErrorCode::InvalidProgram, "the program was changed while it was streamed: it ended after line " +
                                          std::to_string(lines_read) + " of " +
                                          std::to_string(status_.lines_total)},
          now);
    return;
  }
  if (!isStopping()) enter(PackmlState::Completing);
  beginPhase(Phase::Draining, now);
  askForRest();
}

void Streamer::Machine::elapse(double now) {
  if (!isWaiting()) return;
  if (isStopping() && now >= safe_stop_by_) {
    finishAborted(
        phase_ == Phase::Offline
            ? "; the link did not come back, so that the machine was not told to stop: look after it"
            : "; the machine did not confirm the safe stop");
  } else if (!isStopping() && now >= timer_.quietSince() + silenceLimit()) {
    timeOut(now);
  } else if (now >= timer_.retryAt()) {
    proof_.doubt(settings_.window_lines + 2);  // answers to what was sent may be late, not lost
    retry(now);
  } else if (isSettling() && now >= settle_until_) {
    proceed(now);
  }
}

void Streamer::Machine::retry(double now) {
  timer_.asked(now);
  switch (phase_) {
    case Phase::Identifying:
      output_ += firmware_->identification() + "\n";
      break;
    case Phase::Numbering:
      if (isStopping()) output_ += urgentStop();
      output_ += firmware_->framed(base_, firmware_->numberedFrom(base_));
      probe(now);
      break;
    case Phase::Reporting:
      if (++report_attempts_ < kReportAttempts) {
        output_ += reports_.back() + "\n";
      } else {
        onOk({}, now);  // a machine without reports prints all the same
      }
      break;
    case Phase::Feeding:
      phase_ = Phase::Probing;
      settle_until_ = 0.0;
      probe(now);
      break;
    case Phase::Probing:
      probe(now);
      break;
    case Phase::Draining:
      askForRest();
      break;
    case Phase::Idle:
    case Phase::Offline:
      break;
  }
}

/// What stops the machine without waiting for the numbering to be agreed on: firmware that is busy heating
/// may not answer for minutes, but runs these as soon as it can.
std::string Streamer::Machine::urgentStop() const {
  std::string text;
  for (const std::string& command : firmware_->interruption()) text += command + "\n";
  for (const std::string& command : safeStop()) text += command + "\n";
  return text;
}

std::vector<std::string> Streamer::Machine::safeStop() const {
  std::vector<std::string> commands = firmware_->stop();
  if (settings_.keep_heaters_on) return commands;
  const std::vector<std::string> off = firmware_->heatersOff();
  commands.insert(commands.end(), off.begin(), off.end());
  return commands;
}

void Streamer::Machine::timeOut(double now) {
  if (status_.state != PackmlState::Starting) {
    abort({ErrorCode::TimedOut,
           "no answer from the machine for " + seconds(timer_.quietFor(now)) + whereItStands()},
          now);
  } else if (has_answered_) {
    abort({ErrorCode::Rejected,
           "the machine answers, but does not check line numbers as " + settings_.firmware + " does"},
          now);
  } else {
    abort({ErrorCode::TimedOut, "no machine answered within " + seconds(settings_.connect_timeout_s) +
                                    "; is it on, and is the baud rate right?"},
          now);
  }
}

bool Streamer::Machine::pause(double now) {
  if (status_.state != PackmlState::Execute) return false;
  enter(PackmlState::Holding);
  if (phase_ == Phase::Feeding) proceed(now);
  return true;
}

bool Streamer::Machine::resume(double now) {
  if (status_.state != PackmlState::Held && status_.state != PackmlState::Holding) return false;
  is_paused_by_machine_ = false;
  if (status_.state == PackmlState::Holding) enter(PackmlState::Held);
  enter(PackmlState::Unholding);
  enter(PackmlState::Execute);
  if (phase_ == Phase::Feeding) proceed(now);
  return true;
}

void Streamer::Machine::abort(const Failure& why, double now) {
  if (isStopping() || isFinal(status_.state)) return;
  status_.failure = why;
  enter(PackmlState::Aborting);
  if (!has_begun_) {
    finishAborted("");
    return;
  }
  prepareSafeStop(now);
  beginNumbering(base_, now);
}

void Streamer::Machine::prepareSafeStop(double now) {
  safe_stop_by_ = now + settings_.safe_stop_timeout_s;
  safe_stop_latest_ = now + std::max(settings_.safe_stop_timeout_s, settings_.blocking_timeout_s);
  base_ = feed_.end() + kSafeStopGap;
  feed_ = LineFeed(sourceOf(safeStop()), base_ + 1);
  sent_.clear();
  settle_until_ = 0.0;
  must_send_one_ = false;
}

/// A machine whose link is lost goes on heating: it is asked to stop as soon as it can be reached again.
void Streamer::Machine::disconnect(const std::string& why, double now) {
  if (isFinal(status_.state) || phase_ == Phase::Offline) return;
  if (!isStopping()) {
    status_.failure = {ErrorCode::Disconnected, why + whereItStands()};
    enter(PackmlState::Aborting);
    if (!has_begun_) {
      finishAborted("");
      return;
    }
    prepareSafeStop(now);
  }
  received_.clear();
  output_.clear();
  phase_ = Phase::Offline;
}

void Streamer::Machine::reconnect(double now) {
  if (phase_ != Phase::Offline) return;
  safe_stop_by_ = now + settings_.safe_stop_timeout_s;
  beginNumbering(base_, now);
}

void Streamer::Machine::finishAborted(const std::string& remark) {
  status_.failure.message += remark;
  phase_ = Phase::Idle;
  sent_.clear();
  enter(PackmlState::Aborted);
}

std::string Streamer::Machine::takeOutput() { return std::exchange(output_, {}); }

std::vector<PackmlState> Streamer::Machine::takeStateChanges() { return std::exchange(entered_, {}); }

// What the streamer makes of the machine's replies.

void Streamer::Machine::receive(std::string_view bytes, double now) {
  constexpr std::size_t kLongestReply = 4096;
  while (!bytes.empty()) {
    const std::size_t end = bytes.find('\n');
    received_ += bytes.substr(0, end);
    if (end == std::string_view::npos) {
      if (received_.size() > kLongestReply) received_.clear();
      break;
    }
    bytes.remove_prefix(end + 1);
    const MarlinReply reply = firmware_->read(received_);
    received_.clear();
    onReply(reply, now);
  }
  if (phase_ == Phase::Feeding) proceed(now);
}

void Streamer::Machine::onReply(const MarlinReply& reply, double now) {
  if (heard_) heard_(reply);
  if (phase_ == Phase::Idle) return;
  if (!reply.firmware_name.empty()) onIdentity(reply, now);
  if (reply.temperatures) status_.temperatures = reply.temperatures;
  if (reply.position) status_.position = reply.position;
  if (phase_ == Phase::Draining && isStopping() && reply.temperatures && isSafe(*reply.temperatures)) {
    finishAborted("");
    return;
  }
  const bool is_ok_of_resend = std::exchange(expects_ok_of_resend_, false) && reply.kind == ReplyKind::Ok;
  if (reply.kind != ReplyKind::Information && reply.kind != ReplyKind::Warning) {
    has_answered_ = true;
    if (status_.state != PackmlState::Starting) timer_.restart(now);
    if (isSettling()) settle_until_ = now + settings_.settle_s;
  }
  // A machine that boots, or that another sender has made heat, answers later.
  const bool is_alive = reply.kind == ReplyKind::Busy || reply.temperatures;
  if (is_alive && status_.state == PackmlState::Starting) timer_.restart(now);
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
      status_.message = reply.text;
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
      abort({ErrorCode::Cancelled, "the machine ends the job: \"" + reply.text + "\"" + whereItStands()},
            now);
      break;
    case ReplyKind::Busy:
      safe_stop_by_ = std::min(now + settings_.safe_stop_timeout_s, safe_stop_latest_);
      break;
    case ReplyKind::LineError:
    case ReplyKind::Unreadable:
    case ReplyKind::Information:
      break;
  }
}

void Streamer::Machine::onOk(const MarlinReply& reply, double now) {
  if (phase_ == Phase::Identifying) {
    beginNumbering(0, now);
  } else if (phase_ == Phase::Reporting) {
    reports_.pop_back();
    report_attempts_ = 0;
    nextReport(now);
  } else if (phase_ == Phase::Draining && !isStopping()) {
    phase_ = Phase::Idle;
    enter(PackmlState::Complete);
  } else if (phase_ == Phase::Feeding || phase_ == Phase::Probing) {
    odd_requests_ = 0;
    if (reply.line && *reply.line < feed_.end()) {
      sent_.acknowledgeUpTo(*reply.line);
      acknowledgedUpTo(*reply.line);
    } else if (const auto number = sent_.acknowledge()) {
      acknowledgedUpTo(*number);
    }
  }
}

void Streamer::Machine::acknowledgedUpTo(std::uint64_t line) {
  if (isStopping() || line <= status_.lines_acknowledged) return;
  undone_.acknowledge(line);
  status_.commands_not_done = undone_.count();
  proof_.acknowledged();
  status_.lines_acknowledged = line;
  status_.layer = feed_.layerOf(line);
}

void Streamer::Machine::onResend(const MarlinReply& reply, double now) {
  expects_ok_of_resend_ = true;
  const bool is_of_probe = unanswered_probes_ > 0;
  if (is_of_probe) --unanswered_probes_;
  if (!reply.line) return;
  if (phase_ == Phase::Numbering) {
    if (*reply.line != base_ + 1) return;
    refusals_in_a_row_ = 0;
    sent_.clear();
    if (!isStopping()) proof_.asked(base_ + 1);
    if (isStopping()) {
      beginPhase(Phase::Feeding, now);
      proceed(now);
    } else {
      nextReport(now);
    }
  } else if (phase_ == Phase::Probing) {
    if (!isRefuted(*reply.line, now)) onProbeAnswer(*reply.line, now);
  } else if (phase_ == Phase::Feeding) {
    if (is_of_probe && *reply.line == rewound_to_) return;
    if (isRefuted(*reply.line, now)) return;
    if (*reply.line == rewound_to_ && sent_.absorbRefusal()) return;
    if (goTo(*reply.line, now)) onRefusal(*reply.line, now);
  }
}

/// What was sent after the refused line is refused too or discarded. Sending waits for that to be over: the
/// answers would ask for lines that are under way again, whose second copies would be refused in turn, and so
/// for ever.
void Streamer::Machine::onRefusal(std::uint64_t wanted, double now) {
  ++status_.resends;
  sent_.refuse(wanted);
  must_send_one_ = true;
  settle_until_ = now + settings_.settle_s;
}

void Streamer::Machine::settle(double now) {
  if (!isSettling()) return;
  const bool is_answer_due = sent_.hasStale() || expects_ok_of_resend_ || unanswered_probes_ > 0;
  if (now < settle_until_ && is_answer_due) return;
  unanswered_probes_ = 0;
  sent_.dropStale();
  settle_until_ = 0.0;
  // Some firmware says no ok after a request; one that comes later than this counts for a line.
  if (std::exchange(expects_ok_of_resend_, false)) proof_.doubt(1);
}

/// A job has ended when its motions have. A safe stop has ended when the machine says that it no longer
/// heats: the lines it has taken may still wait behind others.
void Streamer::Machine::askForRest() {
  output_ += (isStopping() ? firmware_->harmless() : firmware_->endOfMotions()) + "\n";
}

bool Streamer::Machine::isSafe(const MarlinTemperatures& temperatures) const {
  if (settings_.keep_heaters_on) return true;
  const bool is_bed_off = !temperatures.bed_c || temperatures.bed_target_c == 0.0;
  return temperatures.nozzle_target_c == 0.0 && is_bed_off;
}

/// Goes on with `line`, which the firmware has asked for.
bool Streamer::Machine::goTo(std::uint64_t line, double now) {
  if (!feed_.rewind(line)) {
    if (++odd_requests_ < kMostOddRequests) return false;
    abort({ErrorCode::Rejected, "the machine asks for line " + std::to_string(line) +
                                    "; expected one up to " + std::to_string(feed_.end()) + whereItStands()},
          now);
    return false;
  }
  odd_requests_ = 0;
  refusals_in_a_row_ = line == rewound_to_ ? refusals_in_a_row_ + 1 : 0;
  rewound_to_ = line;
  if (!isStopping()) {
    proof_.asked(line);
    undone_.rewind(line);
    status_.commands_not_done = undone_.count();
    status_.lines_acknowledged = line - 1;
    status_.layer = feed_.layerOf(line - 1);
  }
  if (refusals_in_a_row_ < kMostRefusals) return true;
  abort({ErrorCode::Rejected, "the machine refused line " + std::to_string(line) + " " +
                                  std::to_string(kMostRefusals) + " times" + whereItStands()},
        now);
  return false;
}

void Streamer::Machine::onStart(double now) {
  if (status_.state == PackmlState::Starting) return identify(now);
  abort({ErrorCode::DeviceError, "the machine was reset" + whereItStands()}, now);
}

void Streamer::Machine::onFatal(const MarlinReply& reply, double now) {
  abort({ErrorCode::Rejected, "the machine halted: \"" + reply.text + "\"" + whereItStands()}, now);
}

void Streamer::Machine::onPause(const MarlinReply& reply, double now) {
  status_.message = reply.text;
  if (pause(now)) is_paused_by_machine_ = true;
}

void Streamer::Machine::onNotDone(const MarlinReply& reply) {
  status_.message = reply.text;
  if (isStopping()) return;
  if (undone_.count() == 0) status_.first_not_done = reply.text;
  undone_.announce();
}

/// Nothing but the question for its name has been sent yet.
void Streamer::Machine::onIdentity(const MarlinReply& reply, double now) {
  status_.firmware_name = reply.firmware_name;
  if (phase_ != Phase::Identifying || firmware_->isSpokenBy(reply.firmware_name)) return;
  abort({ErrorCode::Rejected, "the machine's firmware is \"" + reply.firmware_name +
                                  "\", which does not speak " + settings_.firmware +
                                  "; expected another stream.firmware"},
        now);
}

std::string Streamer::Machine::whereItStands() const {
  return "; line " + std::to_string(status_.lines_acknowledged) + " of " +
         std::to_string(status_.lines_total) + " was the last acknowledged";
}

}  // namespace lamina
