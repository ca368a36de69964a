// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/marlin/line_enquiry.hpp"

#include <algorithm>
#include <string_view>

#include "lamina/base/edit_distance.hpp"

namespace lamina {
namespace {

// Longer than any command that is sent without a number, which no checksum protects.
constexpr std::size_t kBackspaces = 16;
// Without a word, after which what was in the line buffer has been refused or run [s].
constexpr double kQuietTime = 0.25;
// Beyond every number that a job has, and its safe stop.
constexpr std::uint64_t kBeyondTheJob = 100'000;

/// Noise may have changed bytes of either name; that it is the job's machine is proven by its counter.
bool areAlike(std::string_view name, std::string_view expected) {
  constexpr std::size_t kMostDamage = 4;  // bytes
  constexpr std::size_t kLongestName = 256;
  return editDistance(name.substr(0, kLongestName), expected.substr(0, kLongestName)) <=
         std::min(kMostDamage, expected.size() / 8);
}

}  // namespace

LineEnquiry::LineEnquiry(const StreamOrder& order, std::shared_ptr<const MarlinFirmware> firmware)
    : settings_(order.settings),
      firmware_(std::move(firmware)),
      unfinished_(order.unfinished.value_or(UnfinishedLines{})),
      base_(order.line_base),
      lines_total_(order.program.lines()),
      wrong_number_(base_ + lines_total_ + kBeyondTheJob),
      timer_(order.settings.probe_after_s) {}

void LineEnquiry::start(double now) { enter(Step::Emptying, now); }

void LineEnquiry::enter(Step step, double now) {
  step_ = step;
  timer_.restart(now);
  quiet_at_ = now + std::max(kQuietTime, settings_.settle_s);
  ask(now);
}

void LineEnquiry::ask(double now) {
  timer_.asked(now);
  if (step_ == Step::Emptying) {
    output_ += std::string(kBackspaces, '\b') + "\n";
  } else if (step_ == Step::Naming) {
    output_ += firmware_->identification() + "\n";
  } else if (step_ == Step::Counting) {
    // Another one each time, since Marlin passes over the number that it has taken last without a word.
    wrong_number_ += 10;
    output_ += firmware_->framed(wrong_number_, firmware_->harmless());
  }
}

void LineEnquiry::fail(ErrorCode code, const std::string& why) {
  failure_ = {code, why + "; line " + std::to_string(unfinished_.taken_through) + " of " +
                        std::to_string(lines_total_) + " was certainly taken, no line beyond " +
                        std::to_string(unfinished_.sent_through) + " was sent, and nothing was done now"};
}

void LineEnquiry::hear(const FirmwareReply& reply, double now) {
  if (isOver()) return;
  // Reports come without being asked for.
  const bool is_answer_to_line = reply.kind == ReplyKind::Ok || reply.kind == ReplyKind::Resend;
  if (is_answer_to_line) quiet_at_ = std::max(quiet_at_, now + settings_.settle_s);
  const bool is_alive = reply.kind == ReplyKind::Busy || reply.temperatures;
  if (is_alive) timer_.restart(now);
  if (reply.kind == ReplyKind::Start) {
    fail(ErrorCode::DeviceError, "the machine was reset: its position and its counter of lines are gone");
  } else if (reply.kind == ReplyKind::Fatal) {
    fail(ErrorCode::Rejected, "the machine halted: \"" + reply.text + "\"");
  } else if (step_ == Step::Emptying || step_ == Step::Quieting) {
    // A refusal discards what comes behind it.
    if (reply.kind == ReplyKind::Resend) quiet_at_ = now + std::max(kQuietTime, settings_.settle_s);
  } else if (step_ == Step::Naming) {
    if (!reply.firmware_name.empty() && !areAlike(reply.firmware_name, unfinished_.firmware_name))
      return fail(ErrorCode::Rejected, "the machine's firmware is \"" + reply.firmware_name +
                                           "\"; that of the job was \"" + unfinished_.firmware_name + "\"");
    is_named_ = is_named_ || !reply.firmware_name.empty();
    const bool is_answer = reply.kind == ReplyKind::Ok && (is_named_ || unfinished_.firmware_name.empty());
    if (is_answer) enter(Step::Quieting, now);
  } else if (reply.kind == ReplyKind::Resend && reply.line) {
    onCounted(*reply.line, now);
  }
}

void LineEnquiry::onCounted(std::uint64_t wanted, double now) {
  // One answer may be noise; two alike are not.
  if (wanted_ == wanted) {
    step_ = Step::Confirming;
    quiet_at_ = now + settings_.settle_s;
    return;
  }
  wanted_ = wanted;
  step_ = Step::Counting;
  timer_.restart(now);
  ask(now);
}

void LineEnquiry::conclude() {
  const std::uint64_t wanted = wanted_.value_or(0);
  const std::uint64_t first = base_ + unfinished_.taken_through + 1;
  const std::uint64_t last = base_ + unfinished_.sent_through + 1;
  if (wanted >= first && wanted <= last) {
    taken_ = wanted - 1;
  } else {
    fail(ErrorCode::DeviceError, "the machine waits for line number " + std::to_string(wanted) +
                                     "; expected one from " + std::to_string(first) + " to " +
                                     std::to_string(last) +
                                     ": it was reset or stopped, or has run something else since");
  }
}

void LineEnquiry::elapse(double now) {
  if (isOver()) return;
  if (waitsForQuiet()) {
    if (now < quiet_at_) return;
    if (step_ == Step::Emptying) return enter(Step::Naming, now);
    if (step_ == Step::Quieting) return enter(Step::Counting, now);
    conclude();
  } else if (now >= timer_.quietSince() + settings_.connect_timeout_s) {
    if (is_named_)
      fail(ErrorCode::Rejected, "the machine answers, but does not check line numbers as Marlin does");
    else
      fail(ErrorCode::TimedOut, "no machine said who it is within " +
                                    std::to_string(static_cast<int>(settings_.connect_timeout_s)) + " s");
  } else if (now >= timer_.retryAt()) {
    ask(now);
  }
}

double LineEnquiry::nextDeadline() const {
  if (waitsForQuiet()) return quiet_at_;
  return std::min(timer_.retryAt(), timer_.quietSince() + settings_.connect_timeout_s);
}

}  // namespace lamina
