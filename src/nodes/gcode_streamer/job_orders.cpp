// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What others ask of the job under way, and what is said of it to who stops the machine in this node's place.
#include <ros/ros.h>

#include <algorithm>

#include "gcode_streamer.hpp"
#include "refusal_text.hpp"
#include "status.hpp"

namespace lamina {
namespace {

/// A machine to which nothing was sent yet may be at work for somebody else.
bool isAtWork(PackmlState state) {
  return state != PackmlState::Idle && state != PackmlState::Starting && !isFinal(state);
}

/// What a start-up has heated stays hot between jobs. A dryer that the operator switched on is not this
/// node's.
bool isAtWork(const lamina_msgs::StartupStep& step, const StartupSettings& settings) {
  using Step = lamina_msgs::StartupStep;
  if (step.name == "dry_pellets" && settings.dry_code.empty()) return false;
  return step.state == Step::RUNNING || (step.state == Step::DONE && step.name == "heat_bed");
}

}  // namespace

bool GcodeStreamer::holdPrepared(bool is_held) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_preparing_) is_hold_due_ = is_held;
  return is_preparing_;
}

bool GcodeStreamer::onPause(Trigger::Request&, Trigger::Response& response) {
  const bool is_prepared = holdPrepared(true);
  const auto job = session();
  const PackmlState state = job ? job->status().state : PackmlState::Idle;
  const bool is_begun = state == PackmlState::Execute;
  response.success = is_prepared || is_begun || state == PackmlState::Starting;
  response.message = std::string("state is ") + toString(state) + "; only Starting and Execute can be paused";
  if (response.success)
    response.message = is_begun ? "holding after the lines under way" : "holding before the first line";
  if (response.success && job) job->pause();
  return true;
}

bool GcodeStreamer::onResume(Trigger::Request&, Trigger::Response& response) {
  const bool is_prepared = holdPrepared(false);
  const auto job = session();
  const PackmlState state = job ? job->status().state : PackmlState::Idle;
  response.success = is_prepared || state == PackmlState::Starting || state == PackmlState::Holding ||
                     state == PackmlState::Held;
  response.message = response.success
                         ? "going on"
                         : std::string("state is ") + toString(state) + "; only Held can be resumed";
  if (response.success && job) job->resume();
  return true;
}

bool GcodeStreamer::onAbort(Trigger::Request&, Trigger::Response& response) {
  const auto job = session();
  const bool is_starting_up = !job && startup_.isBusy();
  response.success = job != nullptr || is_starting_up;
  response.message = response.success ? "stopping the machine" : "no job is under way";
  if (job) job->abort({ErrorCode::Cancelled, "aborted on request"});
  if (!is_starting_up) return true;
  try {
    startup_.abort();
  } catch (const Error& error) {
    response.success = false;
    response.message = error.what();
  }
  return true;
}

bool GcodeStreamer::onChange(lamina_msgs::ChangeJob::Request& request,
                             lamina_msgs::ChangeJob::Response& response) {
  try {
    const LiveChange change = liveChangeOf(request.setting, request.value);
    const auto job = session();
    if (!job) throw Rejected("no job is under way");
    const std::string refusal = job->change(change);
    if (!refusal.empty()) throw Rejected(refusal);
  } catch (const Error&) {
    const Failure failure = currentFailure();
    ROS_ERROR_STREAM(refusalText({"change", request.setting, ""}, failure));
    response.status = toMessage(failure);
  }
  return true;
}

/// A print server prints on by itself.
MachinePulse GcodeStreamer::pulse() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  MachinePulse pulse;
  const bool is_streaming = session_ != nullptr && isAtWork(status_.state);
  const bool is_started_up = std::any_of(
      steps_.begin(), steps_.end(), [this](const auto& step) { return isAtWork(step, settings_.startup); });
  pulse.is_at_work = (is_streaming || is_started_up) && settings_.port.name.rfind("http", 0) != 0;
  pulse.has_job = is_streaming;
  pulse.port = settings_.port;
  pulse.firmware = settings_.stream.firmware;
  const bool is_known = is_streaming || !status_.firmware_name.empty();
  if (pulse.firmware == kAnyFirmware && is_known) pulse.firmware = protocolOfFirmware(status_.firmware_name);
  pulse.keeps_heaters_on = settings_.stream.keep_heaters_on;
  if (!is_of_toolpath_) pulse.program = job_;
  return pulse;
}

}  // namespace lamina
