// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "followed_job.hpp"

#include <utility>

#include "lamina/base/text_search.hpp"
#include "lamina/streaming/job/packml.hpp"
#include "names.hpp"

namespace lamina {

std::optional<int> alarmOfAnyNode(const lamina_msgs::Status& status) {
  using Status = lamina_msgs::Status;
  switch (status.code) {
    case Status::OK:
      return 0;
    case Status::CANCELLED:
      return contains(status.message, names::kNodeEnded) ? 2202 : 0;
    case Status::DISCONNECTED:
      return 3101;
    case Status::TIMED_OUT:
      return 3105;
    default:
      return std::nullopt;
  }
}

ExecutorPhase phaseOf(const lamina_msgs::MachineState& state) {
  switch (static_cast<PackmlState>(state.state)) {
    case PackmlState::Starting:
      return ExecutorPhase::Starting;
    case PackmlState::Execute:
    case PackmlState::Completing:
      return ExecutorPhase::Running;
    case PackmlState::Holding:
    case PackmlState::Suspending:
      return ExecutorPhase::Pausing;
    case PackmlState::Held:
    case PackmlState::Suspended:
      return ExecutorPhase::Paused;
    case PackmlState::Unholding:
    case PackmlState::Unsuspending:
      return ExecutorPhase::Resuming;
    case PackmlState::Stopping:
    case PackmlState::Aborting:
    case PackmlState::Clearing:
    case PackmlState::Resetting:
      return ExecutorPhase::Stopping;
    case PackmlState::Complete:
      return ExecutorPhase::Done;
    case PackmlState::Idle:
    case PackmlState::Stopped:
    case PackmlState::Aborted:
      return ExecutorPhase::Resting;
  }
  return ExecutorPhase::Resting;
}

FollowedJob::FollowedJob(ExecutorLanguage language) : language_(std::move(language)) {}

void FollowedJob::begin(const StartOrder& order, double now_s, const ros::Time& now) {
  order_ = order.order;
  program_ = order.program;
  ordered_ = now;
  ordered_s_ = now_s;
  is_taken_up_ = false;
  has_begun_ = false;
  has_run_ = false;
  last_ = {};
  printed_ = {};
}

void FollowedJob::takeUp(std::uint64_t order) { is_taken_up_ = is_taken_up_ || order_ == order; }

bool FollowedJob::takeUntaken(double now_s, double patience_s) {
  if (!order_ || is_taken_up_ || now_s - ordered_s_ <= patience_s) return false;
  ordered_s_ = now_s;
  return true;
}

std::optional<ExecutorReport> FollowedJob::seen() const {
  if (!has_machine_) return std::nullopt;
  return reportOf(machine_);
}

bool FollowedJob::isOfOrder(const lamina_msgs::MachineState& state) const {
  if (language_.match == StateMatch::AnyJob || has_begun_) return true;
  return state.job == program_ && state.header.stamp >= ordered_;
}

std::optional<ExecutorReport> FollowedJob::hear(const lamina_msgs::MachineState& state) {
  machine_ = state;
  has_machine_ = true;
  ExecutorReport report = reportOf(state);
  const bool is_job_known = order_ ? has_begun_ : !isAtRest(last_.phase);
  if (is_job_known && state.state == lamina_msgs::MachineState::IDLE) return restarted(std::move(report));
  // A job that was started here ends by its result alone: a latched state may be that of the job before.
  if (order_ && (isAtRest(report.phase) || !isOfOrder(state))) return std::nullopt;
  report.has_lost_motions =
      report.phase == ExecutorPhase::Resting && has_run_ && language_.is_stopped_by(state.status);
  has_begun_ = true;
  has_run_ = has_run_ || (report.phase != ExecutorPhase::Starting &&
                          report.phase != ExecutorPhase::Stopping && report.phase != ExecutorPhase::Resting);
  last_ = report;
  return report;
}

/// A job never comes back to Idle: this is another process, which knows nothing of the job.
ExecutorReport FollowedJob::restarted(ExecutorReport report) {
  report.order = order_.value_or(0);
  order_.reset();
  report.phase = ExecutorPhase::Resting;
  report.alarm = 2202;
  report.failure = language_.node + " was started anew; its job was cut off";
  report.program = last_.program;
  report.lines = last_.lines;
  report.progress = last_.progress;
  last_ = report;
  return report;
}

std::optional<ExecutorReport> FollowedJob::end(std::uint64_t order, const JobEnd& end) {
  if (order_ != order) return std::nullopt;
  // What was said last may be of the job before.
  const bool is_said = has_begun_ || language_.match == StateMatch::AnyJob;
  // As of the order: without it what was printed before counts as well.
  ExecutorReport report = is_said ? reportOf(machine_) : ExecutorReport();
  report.order = order;
  order_.reset();
  const bool is_done = end.has_succeeded && end.status && end.status->code == lamina_msgs::Status::OK;
  report.phase = is_done ? ExecutorPhase::Done : ExecutorPhase::Resting;
  report.alarm = end.status ? language_.alarm_of(*end.status) : 2202;
  report.failure = end.status ? end.status->message : "the executor gave no result: " + end.outcome;
  // Actionlib gives an empty result for goals that were never taken up.
  if (!is_done && end.status && end.status->message.empty())
    report.failure = "the executor did not take the job up: " + end.outcome;
  if (end.status) report.progress.taken_through = end.taken_through;
  // A machine that has got no line yet of this order keeps what it had.
  const bool is_cancelled = end.status && end.status->code == lamina_msgs::Status::CANCELLED;
  const bool has_lines =
      is_cancelled ? report.progress.taken_through > 0 || (has_begun_ && report.progress.sent_through > 0)
                   : has_run_;
  report.has_lost_motions = end.status && has_lines && language_.is_stopped_by(*end.status);
  last_ = report;
  return report;
}

ExecutorReport FollowedJob::reportOf(const lamina_msgs::MachineState& state) const {
  ExecutorReport report;
  report.phase = phaseOf(state);
  report.order = order_.value_or(0);
  report.program = state.job;
  report.lines = state.lines_total;
  report.progress.sent_through = state.lines_sent;
  report.progress.taken_through = state.lines_acknowledged;
  report.progress.layer = state.layer;
  report.alarm = language_.alarm_of(state.status);
  report.failure = state.status.message;
  addPrinted(report);
  return report;
}

void FollowedJob::addPrinted(ExecutorReport& report) const {
  if (report.program.empty() || printed_.job != report.program) return;
  if (order_ && (printed_.job != program_ || printed_.header.stamp < ordered_)) return;
  report.progress.path_mm = 1e3 * printed_.laid_length;
  report.progress.deposited_mm3 = 1e9 * printed_.laid_volume;
}

}  // namespace lamina
