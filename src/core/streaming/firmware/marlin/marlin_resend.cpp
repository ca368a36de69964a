// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/marlin/marlin_resend.hpp"

#include <algorithm>
#include <utility>

namespace lamina {
namespace {

// A line that is refused this often without any progress will never be taken.
constexpr int kMostRefusals = 100;
constexpr int kMostOddRequests = 5;

/// Whether the firmware runs a command: it says so, or reports temperatures with the time for which it goes
/// on waiting for them ("W:?"). Reports without it come at intervals, while it is idle too.
bool isRunningCommand(const FirmwareReply& reply) {
  return reply.kind == ReplyKind::Busy || (reply.temperatures && reply.text.find(" W:") != std::string::npos);
}

}  // namespace

MarlinResend::MarlinResend(const StreamSettings& settings) : settings_(settings) {
  settings_.window_lines = windowLines(settings, settings.link);
}

void MarlinResend::beginAt(std::uint64_t line) {
  sent_.clear();
  refusals_in_a_row_ = 0;
  proof_.asked(line);
}

void MarlinResend::forget() {
  sent_.clear();
  wait_until_ = 0.0;
  must_send_one_ = false;
}

bool MarlinResend::hasRoom(std::size_t bytes) const {
  if (sent_.empty() || must_send_one_) return true;
  return sent_.count() < static_cast<std::size_t>(settings_.window_lines) &&
         sent_.bytes() + bytes <= static_cast<std::size_t>(settings_.window_bytes);
}

void MarlinResend::sent(const SentLine& line) {
  must_send_one_ = false;
  sent_.add(line);
}

std::optional<std::uint64_t> MarlinResend::acknowledge(const std::optional<std::uint64_t>& named) {
  odd_requests_ = 0;
  if (!named) return sent_.acknowledge();
  sent_.acknowledgeUpTo(*named);
  return named;
}

bool MarlinResend::hear(const FirmwareReply& reply, double now) {
  proof_.hear(reply);
  const bool is_answer = reply.kind != ReplyKind::Information && reply.kind != ReplyKind::Warning;
  if (isWaiting() && is_answer) wait_until_ = std::max(wait_until_, now + settings_.settle_s);
  if (isWaiting() && waits_for_oks_ && isRunningCommand(reply))
    wait_until_ = std::max(wait_until_, now + waitForLostOk());
  return std::exchange(expects_ok_of_request_, false) && reply.kind == ReplyKind::Ok;
}

bool MarlinResend::takeRequest() {
  expects_ok_of_request_ = true;
  if (unanswered_probes_ == 0) return false;
  --unanswered_probes_;
  return true;
}

MarlinResend::Contradiction MarlinResend::contradictionOf(std::uint64_t wanted, std::uint64_t taken) {
  const bool is_one = proof_.contradicts(wanted, taken);
  const bool is_asking_again = std::exchange(is_asking_again_, is_one);
  if (!is_one) return Contradiction::None;
  return is_asking_again ? Contradiction::Repeated : Contradiction::First;
}

bool MarlinResend::isTooOdd() { return ++odd_requests_ >= kMostOddRequests; }

std::string MarlinResend::follow(std::uint64_t wanted) {
  odd_requests_ = 0;
  refusals_in_a_row_ = isRepeated(wanted) ? refusals_in_a_row_ + 1 : 0;
  rewound_to_ = wanted;
  proof_.asked(wanted);
  if (refusals_in_a_row_ < kMostRefusals) return {};
  return "the machine refused line " + std::to_string(wanted) + " " + std::to_string(kMostRefusals) +
         " times";
}

/// Sending waits for the answers to be over: they would ask for lines that are under way again, whose second
/// copies would be refused in turn, and so for ever.
void MarlinResend::refuse(std::uint64_t wanted, double now) {
  sent_.refuse(wanted);
  must_send_one_ = true;
  waitFor(1, now);
}

void MarlinResend::allRead(double now) {
  sent_.clear();
  waitForProbes(now);
  must_send_one_ = false;
}

void MarlinResend::settle(double now) {
  if (!isWaiting()) return;
  const bool is_answer_due = sent_.hasStale() || expects_ok_of_request_ || unanswered_probes_ > 0;
  if (now < wait_until_ && is_answer_due) return;
  unanswered_probes_ = 0;
  sent_.dropStale();
  wait_until_ = 0.0;
  // Some firmware says no ok after a request; one that comes later than this counts for a line.
  if (std::exchange(expects_ok_of_request_, false)) proof_.doubt(1);
}

}  // namespace lamina
