// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What the streamer makes of the machine's replies.
#include <algorithm>
#include <utility>

#include "streaming/client/streamer_machine.hpp"

namespace lamina {
namespace {

// A line that is refused this often without any progress will never be taken.
constexpr int kMostRefusals = 100;
constexpr int kMostOddRequests = 5;

}  // namespace

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
    case ReplyKind::Information:
      if (reply.text.find("Unknown command") != std::string::npos) status_.message = reply.text;
      break;
    case ReplyKind::Busy:
      safe_stop_by_ = std::min(now + settings_.safe_stop_timeout_s, safe_stop_latest_);
      break;
    case ReplyKind::LineError:
      break;
  }
}

void Streamer::Machine::onOk(const MarlinReply& reply, double now) {
  if (phase_ == Phase::Reporting) {
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
  status_.lines_acknowledged = line;
  status_.layer = feed_.layerOf(line);
}

void Streamer::Machine::onResend(const MarlinReply& reply, double now) {
  expects_ok_of_resend_ = true;
  if (!reply.line) return;
  if (phase_ == Phase::Numbering) {
    if (*reply.line != base_ + 1) return;
    refusals_in_a_row_ = 0;
    sent_.clear();
    if (isStopping()) {
      beginPhase(Phase::Feeding, now);
      proceed(now);
    } else {
      nextReport(now);
    }
  } else if (phase_ == Phase::Probing) {
    onProbeAnswer(*reply.line, now);
  } else if (phase_ == Phase::Feeding) {
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
  if (!isSettling() || (now < settle_until_ && sent_.hasStale())) return;
  sent_.dropStale();
  settle_until_ = 0.0;
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
  if (phase_ == Phase::Numbering) {
    timer_.restart(now);
    retry(now);
    return;
  }
  abort({ErrorCode::DeviceError, "the machine was reset" + whereItStands()}, now);
}

void Streamer::Machine::onFatal(const MarlinReply& reply, double now) {
  abort({ErrorCode::Rejected, "the machine halted: \"" + reply.text + "\"" + whereItStands()}, now);
}

std::string Streamer::Machine::whereItStands() const {
  return "; line " + std::to_string(status_.lines_acknowledged) + " of " +
         std::to_string(status_.lines_total) + " was the last acknowledged";
}

}  // namespace lamina
