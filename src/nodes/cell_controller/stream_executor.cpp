// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stream_executor.hpp"

#include <std_srvs/Trigger.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "lamina/base/text.hpp"
#include "lamina/base/text_search.hpp"
#include "lamina/streaming/job/packml.hpp"
#include "lamina/streaming/job/unstopped_machine.hpp"
#include "names.hpp"
#include "service_call.hpp"

namespace lamina {
namespace {

constexpr double kLongestSilence = 2.0;  // [s] of an executor that says five times a second that it is there

/// In the words of Marlin, RepRapFirmware and Klipper.
bool isHeaterFault(const std::string& message) {
  constexpr std::array<std::string_view, 8> kSigns = {
      "thermal runaway", "heating failed", "mintemp",          "maxtemp",
      "heater fault",    "not heating",    "adc out of range", "temperature excursion"};
  const std::string small = lowerCase(message);
  return std::any_of(kSigns.begin(), kSigns.end(),
                     [&small](std::string_view sign) { return contains(small, sign); });
}

int alarmOfRejection(const std::string& message) {
  if (isHeaterFault(message)) return 3104;
  return contains(message, "the machine halted: ") || contains(message, "the machine has halted: ") ? 3103
                                                                                                    : 3106;
}

/// The alarm that a job's failure raises. Nobody has given up a job whose node was ended.
int alarmOf(const lamina_msgs::Status& status) {
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
    case Status::DEVICE_ERROR:
      return contains(status.message, "was reset") ? 3102 : 3106;
    case Status::REJECTED:
      return alarmOfRejection(status.message);
    default:
      return 3106;
  }
}

/// Whether the job's end has stopped the machine, or told it to stop, after lines of the job: motions that
/// it had accepted are then lost.
bool isStoppedBy(const lamina_msgs::Status& status) {
  using Status = lamina_msgs::Status;
  if (status.code == Status::CANCELLED || status.code == Status::TIMED_OUT) return true;
  return status.code == Status::DISCONNECTED && !contains(status.message, kLinkNotBack) &&
         !contains(status.message, kMayStillPrint);
}

ExecutorPhase phaseOf(PackmlState state) {
  switch (state) {
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

}  // namespace

StreamExecutor::StreamExecutor(ros::NodeHandle node, std::function<void(const ExecutorReport&)> report)
    : report_(std::move(report)),
      client_(node, names::kStreamProgram, false),
      pause_(node.serviceClient<std_srvs::Trigger>(names::kPause)),
      resume_(node.serviceClient<std_srvs::Trigger>(names::kResume)),
      abort_(node.serviceClient<std_srvs::Trigger>(names::kAbort)),
      change_(node.serviceClient<lamina_msgs::ChangeJob>(names::kChangeJob)),
      state_(node.subscribe(names::kMachineState, 100, &StreamExecutor::onState, this)),
      signs_(
          node.subscribe(std::string(names::kStreamProgram) + "/status", 10, &StreamExecutor::onSign, this)),
      last_sign_s_(clock_.now()) {}

void StreamExecutor::start(const StartOrder& order) {
  lamina_msgs::StreamProgramGoal goal;
  goal.program = order.program;
  goal.resume = order.start != ExecutionStart::Anew;
  goal.or_begin = order.start == ExecutionStart::ResumeIfBegun;
  goal.execution = order.execution;
  const std::uint64_t number = order.order;
  order_ = number;
  ordered_s_ = clock_.now();
  is_taken_up_ = false;
  has_begun_ = false;
  has_run_ = false;
  last_ = {};
  client_.sendGoal(
      goal, [this, number](const auto& state, const auto& result) { onDone(number, state, result); },
      [this, number] { is_taken_up_ = is_taken_up_ || order_ == number; });
}

void StreamExecutor::pause() { call(orders_, pause_, "pause"); }

void StreamExecutor::resume() { call(orders_, resume_, "resume"); }

void StreamExecutor::stop() { endJob("stop"); }

void StreamExecutor::abort() { endJob("abort"); }

void StreamExecutor::endJob(const std::string& order) {
  // A goal that has not come through yet would begin after the order.
  if (order_ && !has_begun_) return client_.cancelGoal();
  call(ends_, abort_, order);
}

void StreamExecutor::call(OrderThread& thread, ros::ServiceClient& service, const std::string& order) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!waiting_.give(order, clock_.now())) return;
  }
  thread.give([this, &service, order] {
    std_srvs::Trigger request;
    // What is refused shows in the state, which then does not change in time.
    if (callService(service.getService(), request) && !request.response.success)
      ROS_WARN_STREAM("gcode_streamer refuses the order to " << order << ": " << request.response.message);
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_.answer(order);
  });
}

void StreamExecutor::changeFeed(double feed) {
  orders_.give([this, feed] {
    lamina_msgs::ChangeJob call;
    call.request.setting = "feed";
    call.request.value = feed;
    const bool is_answered = callService(change_.getService(), call);
    const std::lock_guard<std::mutex> lock(mutex_);
    feed_answer_ = {feed, is_answered ? call.response.status.message : "gcode_streamer does not answer"};
  });
}

std::optional<StreamExecutor::FeedAnswer> StreamExecutor::takeFeedAnswer() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(feed_answer_, std::nullopt);
}

std::string StreamExecutor::takeUnanswered(double patience_s) {
  const double now_s = clock_.now();
  if (order_ && !is_taken_up_ && now_s - ordered_s_ > patience_s) {
    ordered_s_ = now_s;
    return "start";
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  return waiting_.take(now_s, patience_s);
}

std::optional<ExecutorReport> StreamExecutor::seen() const {
  if (!has_machine_) return std::nullopt;
  return reportOf(machine_);
}

bool StreamExecutor::isThere() const {
  // A goal that is sent before both ends know each other is lost without a word.
  return clock_.now() - last_sign_s_ < kLongestSilence && client_.isServerConnected();
}

void StreamExecutor::onSign(const actionlib_msgs::GoalStatusArrayConstPtr& /*signs*/) {
  last_sign_s_ = clock_.now();
}

void StreamExecutor::onState(const lamina_msgs::MachineStateConstPtr& state) {
  machine_ = *state;
  has_machine_ = true;
  last_sign_s_ = clock_.now();
  ExecutorReport report = reportOf(*state);
  const bool is_job_known = order_ ? has_begun_ : !isAtRest(last_.phase);
  if (is_job_known && state->state == lamina_msgs::MachineState::IDLE) return onRestart(report);
  // A job that was started here ends by its result alone: a latched state may be that of the job before.
  if (order_ && isAtRest(report.phase)) return;
  report.has_lost_motions = report.phase == ExecutorPhase::Resting && has_run_ && isStoppedBy(state->status);
  has_begun_ = true;
  has_run_ = has_run_ || (report.phase != ExecutorPhase::Starting &&
                          report.phase != ExecutorPhase::Stopping && report.phase != ExecutorPhase::Resting);
  last_ = report;
  report_(report);
}

/// A job never comes back to Idle: this is another process, which knows nothing of the job.
void StreamExecutor::onRestart(ExecutorReport report) {
  if (order_) client_.stopTrackingGoal();
  report.order = order_.value_or(0);
  order_.reset();
  report.phase = ExecutorPhase::Resting;
  report.alarm = 2202;
  report.failure = "gcode_streamer was started anew; its job was cut off";
  report.program = last_.program;
  report.lines = last_.lines;
  report.progress = last_.progress;
  last_ = report;
  report_(report);
}

void StreamExecutor::onDone(std::uint64_t order, const actionlib::SimpleClientGoalState& state,
                            const lamina_msgs::StreamProgramResultConstPtr& result) {
  if (order_ != order) return;
  order_.reset();
  ExecutorReport report = reportOf(machine_);
  report.order = order;
  const bool is_done = state == actionlib::SimpleClientGoalState::SUCCEEDED && result != nullptr &&
                       result->status.code == lamina_msgs::Status::OK;
  report.phase = is_done ? ExecutorPhase::Done : ExecutorPhase::Resting;
  report.alarm = result == nullptr ? 2202 : alarmOf(result->status);
  report.failure =
      result == nullptr ? "the executor gave no result: " + state.toString() : result->status.message;
  // Actionlib gives an empty result for goals that were never taken up.
  if (!is_done && result != nullptr && result->status.message.empty())
    report.failure = "the executor did not take the job up: " + state.toString();
  if (result != nullptr) report.progress.taken_through = result->lines_acknowledged;
  // A machine that has got no line yet of this order keeps what it had.
  const bool is_cancelled = result != nullptr && result->status.code == lamina_msgs::Status::CANCELLED;
  const bool has_lines =
      is_cancelled ? report.progress.taken_through > 0 || (has_begun_ && report.progress.sent_through > 0)
                   : has_run_;
  report.has_lost_motions = result != nullptr && has_lines && isStoppedBy(result->status);
  last_ = report;
  report_(report);
}

ExecutorReport StreamExecutor::reportOf(const lamina_msgs::MachineState& state) const {
  ExecutorReport report;
  report.phase = phaseOf(static_cast<PackmlState>(state.state));
  report.order = order_.value_or(0);
  report.program = state.job;
  report.lines = state.lines_total;
  report.progress.sent_through = state.lines_sent;
  report.progress.taken_through = state.lines_acknowledged;
  report.progress.layer = state.layer;
  report.alarm = alarmOf(state.status);
  report.failure = state.status.message;
  return report;
}

}  // namespace lamina
