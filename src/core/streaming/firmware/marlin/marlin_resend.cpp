// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What answers a request to send lines again, and the probe that provokes one.
#include <cstdint>
#include <string>
#include <utility>

#include "streaming/firmware/marlin/marlin_job.hpp"

namespace lamina {
namespace {

// A line that is refused this often without any progress will never be taken.
constexpr int kMostRefusals = 100;
constexpr int kMostOddRequests = 5;

}  // namespace

void MarlinJob::onResend(const FirmwareReply& reply, double now) {
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
      confirm(now);
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
void MarlinJob::onRefusal(std::uint64_t wanted, double now) {
  ++record_.status.resends;
  sent_.refuse(wanted);
  must_send_one_ = true;
  settle_until_ = now + settings_.settle_s;
}

void MarlinJob::settle(double now) {
  if (!isSettling()) return;
  const bool is_answer_due = sent_.hasStale() || expects_ok_of_resend_ || unanswered_probes_ > 0;
  if (now < settle_until_ && is_answer_due) return;
  unanswered_probes_ = 0;
  sent_.dropStale();
  settle_until_ = 0.0;
  // Some firmware says no ok after a request; one that comes later than this counts for a line.
  if (std::exchange(expects_ok_of_resend_, false)) proof_.doubt(1);
}

/// Asks once more where a request contradicts what is known, and ends the job if it is repeated.
/// @return whether the request must not be followed
bool MarlinJob::isRefuted(std::uint64_t wanted, double now) {
  if (isStopping() || !proof_.contradicts(wanted, line_base_ + record_.status.lines_acknowledged)) {
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
                                     ", which it has taken before: it was reset" + record_.whereItStands()},
        now);
  return true;
}

/// Goes on with `line`, which the firmware has asked for.
bool MarlinJob::goTo(std::uint64_t line, double now) {
  if (!feed_.rewind(line)) {
    if (++odd_requests_ < kMostOddRequests) return false;
    abort(
        {ErrorCode::Rejected, "the machine asks for line " + std::to_string(line) + "; expected one up to " +
                                  std::to_string(feed_.end()) + record_.whereItStands()},
        now);
    return false;
  }
  odd_requests_ = 0;
  refusals_in_a_row_ = line == rewound_to_ ? refusals_in_a_row_ + 1 : 0;
  rewound_to_ = line;
  if (!isStopping()) {
    proof_.asked(line);
    undone_.rewind(line);
    starvation_.rewound(line);
    record_.status.commands_not_done = undone_.count();
    record_.status.lines_acknowledged = line - 1 - line_base_;
    record_.status.layer = feed_.layerOf(line - 1);
  }
  if (refusals_in_a_row_ < kMostRefusals) return true;
  abort({ErrorCode::Rejected, "the machine refused line " + std::to_string(line) + " " +
                                  std::to_string(kMostRefusals) + " times" + record_.whereItStands()},
        now);
  return false;
}

/// Sends a line that the firmware must refuse, naming the line it waits for: a harmless one, with the number
/// after the next one.
void MarlinJob::probe(double) {
  ++record_.status.probes;
  ++unanswered_probes_;
  const std::uint64_t expected = phase_ == Phase::Numbering ? base_ + 1 : feed_.end();
  output_ += firmware_->framed(expected + 1, firmware_->harmless());
}

void MarlinJob::onProbeAnswer(std::uint64_t wanted, double now) {
  if (!goTo(wanted, now)) return;
  // The firmware has read everything that was sent before the probe.
  sent_.clear();
  awaitProbes(now);
  must_send_one_ = false;
  if (wanted < feed_.end()) ++record_.status.resends;
  beginPhase(Phase::Feeding, now);
  const bool may_feed = record_.status.state == PackmlState::Execute || isStopping();
  if (may_feed && feed_.isNextKnown() && feed_.peek() == nullptr) onAllTaken(now);
}

}  // namespace lamina
