// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "streaming/firmware/grbl/grbl_start.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/duration_text.hpp"

namespace lamina {
namespace {

constexpr double kStartPoll = 0.2;  // s
constexpr int kIdleReports = 2;     // one may be from between two motions of somebody else

/// A question, and what stands in its answer before the ok: earlier lines' answers may still come.
struct GrblQuestion {
  const char* line;
  GrblReplyKind answer;
};
constexpr std::array<GrblQuestion, 3> kQuestions = {{
    {"$I\n", GrblReplyKind::Version},
    {"$G\n", GrblReplyKind::Modes},
    {"$$\n", GrblReplyKind::Setting},
}};

}  // namespace

void GrblStart::begin(double now) {
  step_ = Step::Awaiting;
  machine_ = {};
  began_s_ = next_poll_s_ = now;
  idle_reports_ = 0;
  has_unlocked_ = false;
}

std::string GrblStart::takeOutput() { return std::exchange(output_, {}); }

double GrblStart::nextDeadline() const {
  const double give_up = began_s_ + settings_.connect_timeout_s;
  return step_ == Step::Awaiting ? std::min(next_poll_s_, give_up) : give_up;
}

void GrblStart::elapse(double now) {
  if (failure_ || isReady()) return;
  if (settings_.link == LinkKind::Lossy)
    return refuse(
        "the link counts as lossy, and this firmware checks no line: one that is damaged and still reads as "
        "G-code would be run; expected stream.link reliable, where the USB bridge sits on the board "
        "(docs/streaming/firmware/grbl.md)");
  if (now >= began_s_ + settings_.connect_timeout_s) return timeOut();
  if (step_ != Step::Awaiting || now < next_poll_s_) return;
  next_poll_s_ = now + kStartPoll;
  output_ += grbl_byte::kStatus;
}

void GrblStart::timeOut() {
  const std::string limit = wholeSeconds(settings_.connect_timeout_s);
  if (!has_reported_) {
    failure_ = Failure{ErrorCode::TimedOut, "no machine answered '?' as grbl does within " + limit +
                                                "; is it on, and is the baud rate right?"};
  } else if (has_unlocked_ && step_ != Step::Asking) {
    refuse("the machine is still in state " + last_state_ + " after $X; expected Idle");
  } else if (step_ == Step::Awaiting) {
    refuse("the machine is in state " + last_state_ + " since more than " + limit +
           ", for somebody else; expected Idle");
  } else {
    failure_ = Failure{ErrorCode::TimedOut, "the machine answered '?', but not a line, within " + limit};
  }
}

void GrblStart::hear(const GrblReply& reply, double now) {
  if (failure_ || isReady()) return;
  machine_.learn(reply);
  if (reply.kind == GrblReplyKind::Greeting) {
    const GrblDialect dialect = machine_.dialect;
    begin(now);
    machine_.dialect = dialect;
  } else if (reply.kind == GrblReplyKind::Alarm) {
    alarm_code_ = reply.code;
  } else if (reply.kind == GrblReplyKind::Report) {
    has_reported_ = true;
    last_state_ = reply.report->state_text;
    if (step_ == Step::Awaiting) onReport(*reply.report);
  } else if (step_ == Step::Unlocking && reply.kind == GrblReplyKind::Ok) {
    step_ = Step::Awaiting;
  } else if (step_ == Step::Asking) {
    onAnswer(reply);
  }
}

void GrblStart::onReport(const GrblReport& report) {
  idle_reports_ = report.state == GrblState::Idle ? idle_reports_ + 1 : 0;
  if (idle_reports_ >= kIdleReports) {
    ask(0);
  } else if (report.state == GrblState::Alarm) {
    onLocked(report);
  } else if (report.state == GrblState::Check) {
    refuse("the machine is in check mode, in which nothing moves; expected Idle ($C leaves it)");
  } else if (report.state == GrblState::Sleep) {
    refuse("the machine sleeps, and has lost its position; expected Idle (a reset wakes it up, locked)");
  }
}

/// A lock says that the machine may not be where it thinks: unlocking it is a person's decision.
void GrblStart::onLocked(const GrblReport& report) {
  if (has_unlocked_) return;  // the report may be from before
  if (settings_.unlock == UnlockPolicy::Once) {
    has_unlocked_ = true;
    step_ = Step::Unlocking;
    output_ += "$X\n";
    return;
  }
  const int code = report.substate.value_or(alarm_code_);
  const std::string why =
      code > 0 ? "ALARM:" + std::to_string(code) + ", " + meaningOfGrblAlarm(code, machine_.dialect)
               : "no code: after power-up where homing is required, or after a reset in motion";
  refuse("the machine is locked (" + why +
         "); expected Idle: home it ($H), or unlock it ($X, or stream.unlock once) if you know that its "
         "position is right");
}

void GrblStart::ask(std::size_t question) {
  question_ = question;
  is_answered_ = false;
  if (question == kQuestions.size()) {
    step_ = Step::Ready;
    return;
  }
  step_ = Step::Asking;
  output_ += kQuestions[question].line;
}

void GrblStart::onAnswer(const GrblReply& reply) {
  if (reply.kind == kQuestions[question_].answer) is_answered_ = true;
  if (!is_answered_) return;
  if (reply.kind == GrblReplyKind::Ok) {
    ask(question_ + 1);
  } else if (reply.kind == GrblReplyKind::Error) {
    refuse("the machine refuses " + std::string(kQuestions[question_].line, 2) + " (error:" +
           std::to_string(reply.code) + ", " + meaningOfGrblError(reply.code, machine_.dialect) + ")");
  }
}

}  // namespace lamina
