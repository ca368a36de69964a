// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/grbl/grbl_stop.hpp"

#include <utility>

namespace lamina {
namespace {

constexpr double kHaltPoll = 0.1;    // s
constexpr double kResetPoll = 0.25;  // s
constexpr double kResetAgain = 2.0;  // s, more than a board takes to boot

}  // namespace

GrblStop::GrblStop(Motion motion, double timeout_s, double now)
    : reset_by_s_(now + 0.5 * timeout_s), next_step_s_(now + kHaltPoll) {
  if (motion == Motion::EndedByAlarm) {
    reset(now);
  } else {
    output_ = {grbl_byte::kFeedHold, grbl_byte::kStatus};
  }
}

std::string GrblStop::takeOutput() { return std::exchange(output_, {}); }

std::string GrblStop::remark() const {
  return was_moving_ ? "; it was reset in motion, so that its position is lost" : "";
}

void GrblStop::elapse(double now) {
  if (is_confirmed_ || now < next_step_s_) return;
  if (!is_resetting_ && now >= reset_by_s_) {
    was_moving_ = true;
    reset(now);
  } else if (!is_resetting_) {
    // The hold may have been lost; a second one changes nothing.
    output_ += {grbl_byte::kFeedHold, grbl_byte::kStatus};
    next_step_s_ = now + kHaltPoll;
  } else {
    if (!has_greeted_ && now >= reset_at_s_ + kResetAgain) reset(now);
    output_ += grbl_byte::kStatus;
    next_step_s_ = now + kResetPoll;
  }
}

void GrblStop::reset(double now) {
  is_resetting_ = true;
  reset_at_s_ = now;
  output_ += grbl_byte::kReset;
  next_step_s_ = now + kResetPoll;
}

void GrblStop::hear(const GrblReply& reply, double now) {
  if (is_confirmed_) return;
  if (reply.kind == GrblReplyKind::Report) {
    onReport(*reply.report, now);
  } else if (reply.kind == GrblReplyKind::Alarm) {
    constexpr int kResetInMotion = 3;
    if (reply.code == kResetInMotion) was_moving_ = true;
    if (!is_resetting_) reset(now);
  } else if (reply.kind == GrblReplyKind::Greeting && is_resetting_) {
    has_greeted_ = true;
    output_ += grbl_byte::kStatus;
  }
}

void GrblStop::onReport(const GrblReport& report, double now) {
  if (!is_resetting_) return onHalting(report, now);
  const bool is_at_rest =
      report.state == GrblState::Idle || report.state == GrblState::Alarm || report.state == GrblState::Door;
  // A report from before the reset says nothing of the spindle after it.
  is_confirmed_ = has_greeted_ && is_at_rest && report.spindle_speed.value_or(0.0) == 0.0;
}

void GrblStop::onHalting(const GrblReport& report, double now) {
  const int substate = report.substate.value_or(0);
  switch (report.state) {
    case GrblState::Hold:
      if (substate == 0) reset(now);
      break;
    case GrblState::Door:
      if (substate <= 1) reset(now);
      break;
    case GrblState::Alarm:
    case GrblState::Check:
    case GrblState::Sleep:
      reset(now);
      break;
    case GrblState::Idle:
    case GrblState::Tool:
      if (standstill_.isCertainAt(now)) reset(now);
      return;
    default:
      break;
  }
  standstill_.restart();
}

}  // namespace lamina
