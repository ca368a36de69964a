// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "drive_session.hpp"

#include <algorithm>
#include <limits>

namespace lamina {
namespace {

constexpr double kSettling = 0.2;  // s for which joints must be still
constexpr double kCoarser = 10.0;  // tolerance on the tip on the way to the start, that is run fast
constexpr double kPatience = 5.0;  // s that a controller may need to stop by itself

}  // namespace

DriveSession::DriveSession(const DriveMotion& motion, const KinematicModel& model,
                           const DriverSettings& settings, const DriveLinks& links)
    : motion_(motion),
      model_(model),
      settings_(settings),
      links_(links),
      feeder_(motion.path, settings.feeder),
      begin_(ros::Time::now() + ros::Duration(settings.start_delay_s)),
      tracking_(model),
      reports_(settings.tracking, settings.controller_wait_s, begin_) {
  links_.controller.begin();
  status_.feeding.least_queued_s = std::numeric_limits<double>::infinity();
  status_.state = motion.running;
}

bool DriveSession::step(const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (isFinal(status_.state)) return false;
  watch(now);
  feed(jobTime(now));
  follow(jobTime(now));
  return advance(now);
}

/// Stops if the controller does, says nothing, or leaves the path.
void DriveSession::watch(const ros::Time& now) {
  if (given_up_at_) return;
  if (const std::optional<std::string> failure = links_.controller.failure())
    return giveUp(now, {ErrorCode::DeviceError, *failure});
  const double now_s = jobTime(now);
  const bool is_way_to_start = motion_.running == PackmlState::Starting;
  const double most_mm = settings_.tracking.tip_mm * (is_way_to_start ? kCoarser : 1.0);
  std::optional<std::string> silence, deviation;
  {
    const std::lock_guard<std::mutex> lock(report_mutex_);
    silence = reports_.look(now);
    deviation = tracking_.deviation(most_mm);
  }
  const bool is_moving = now_s > 0.0 && now_s < feeder_.restTime();
  if (is_moving && silence) return giveUp(now, {ErrorCode::Disconnected, *silence});
  if (deviation && status_.state != PackmlState::Aborting)
    brake(now_s, {ErrorCode::DeviceError, *deviation}, Lift::No);
}

void DriveSession::feed(double now_s) {
  if (given_up_at_) return;
  if (feeder_.state() == TrajectoryFeederState::Running && fed_s_ > 0.0) {
    const double queued_s = std::max(0.0, fed_s_ - now_s);
    status_.feeding.least_queued_s = std::min(status_.feeding.least_queued_s, queued_s);
    if (queued_s == 0.0 && !was_starved_) ++status_.feeding.starvations;
    was_starved_ = queued_s == 0.0;
  }
  while (const std::optional<TrajectoryChunk> chunk = feeder_.next(now_s)) {
    links_.controller.send(*chunk, begin_);
    links_.process.send(*chunk, begin_, motion_.toolpath_id);
    fed_s_ = chunk->points.back().time_s;
  }
}

void DriveSession::follow(double now_s) {
  if (given_up_at_) return;
  const double rest_s = feeder_.restTime();
  status_.time_s = std::clamp(now_s, 0.0, rest_s);
  const TrajectoryFeederState state = feeder_.state();
  if (state == TrajectoryFeederState::Running || state == TrajectoryFeederState::Finished)
    status_.duration_s = rest_s;
  const JointState wanted = feeder_.at(status_.time_s);
  status_.heading_for = wanted.heading_for;
  status_.tip_mm = model_.bedFromNozzle(wanted.position).translation();
  const std::lock_guard<std::mutex> lock(report_mutex_);
  status_.joint_error = tracking_.joints();
  status_.tip_error_mm = tracking_.tip();
  status_.worst_tip_error_mm = tracking_.worstTip();
  status_.rms_tip_error_mm = tracking_.rmsTip();
}

/// Goes on to the state that is due. False once the motion has ended.
bool DriveSession::advance(const ros::Time& now) {
  if (given_up_at_) {
    const bool is_over = links_.joints.areStillFor(kSettling) || (now - *given_up_at_).toSec() > kPatience;
    if (is_over) status_.state = PackmlState::Aborted;
    return !is_over;
  }
  const double now_s = jobTime(now);
  const bool is_at_rest = now_s >= feeder_.restTime() + kSettling;
  const bool is_planned_end =
      feeder_.state() == TrajectoryFeederState::Finished && now_s >= feeder_.restTime();
  switch (status_.state) {
    case PackmlState::Holding:
      if (is_at_rest) status_.state = PackmlState::Held;
      return true;
    case PackmlState::Unholding:
      status_.state = PackmlState::Execute;
      return true;
    case PackmlState::Aborting:
      if (is_at_rest) status_.state = PackmlState::Aborted;
      return !is_at_rest;
    case PackmlState::Execute:
      if (is_planned_end) status_.state = PackmlState::Completing;
      return true;
    default:  // Starting or Completing
      return !is_planned_end || !is_at_rest || complete(now);
  }
}

/// The motion is done once the controller says so. Whether it goes on.
bool DriveSession::complete(const ros::Time& now) {
  if (links_.controller.isDone()) {
    status_.state = PackmlState::Complete;
    return false;
  }
  const double overdue_s = jobTime(now) - feeder_.restTime();
  const TrackingLimits& limits = settings_.tracking;
  const double patience_s = limits.silence_by == SilenceBy::Stamps
                                ? std::max(limits.silence_s, settings_.controller_wait_s)
                                : limits.silence_s;
  if (overdue_s > patience_s)
    giveUp(now, {ErrorCode::TimedOut, "the controller has not come to the end of its last goal " +
                                          std::to_string(overdue_s) + " s after it was due"});
  return true;
}

void DriveSession::hear(const ControllerReport& report, const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(report_mutex_);
  reports_.hear(report.stamp, now);
  tracking_.add(report.wanted, report.actual);
}

std::optional<std::string> DriveSession::pause(const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (status_.state != PackmlState::Execute)
    return std::string("state is ") + toString(status_.state) + "; only Execute can be paused";
  feeder_.pause(jobTime(now));
  if (feeder_.state() != TrajectoryFeederState::Paused)
    return std::string("the motion ends before it could be paused");
  status_.state = PackmlState::Holding;
  feed(jobTime(now));
  return std::nullopt;
}

std::optional<std::string> DriveSession::resume(const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (status_.state != PackmlState::Held)
    return std::string("state is ") + toString(status_.state) + "; only Held can be resumed";
  feeder_.resume(jobTime(now));
  {
    const std::lock_guard<std::mutex> report_lock(report_mutex_);
    reports_.restart(now);
  }
  fed_s_ = 0.0;  // at rest nothing is missing
  status_.state = PackmlState::Unholding;
  feed(jobTime(now));
  return std::nullopt;
}

void DriveSession::abort(const ros::Time& now, const Failure& why) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (isFinal(status_.state) || status_.state == PackmlState::Aborting) return;
  brake(jobTime(now), why, settings_.lift_mm > 0.0 ? Lift::Yes : Lift::No);
}

void DriveSession::brake(double now_s, const Failure& why, Lift lift) {
  status_.state = PackmlState::Aborting;
  status_.failure = why;
  try {
    if (lift == Lift::Yes)
      feeder_.abort(now_s, {settings_.lift_mm, settings_.lift_mm_s}, model_);
    else
      feeder_.abort(now_s);
  } catch (const Unreachable& error) {
    status_.failure.message += "; the tool was not lifted: " + std::string(error.what());
  }
  feed(now_s);
}

/// The controller is to stop by itself: nothing more is sent to it.
void DriveSession::giveUp(const ros::Time& now, const Failure& why) {
  if (status_.failure.code == ErrorCode::Ok) status_.failure = why;
  status_.state = PackmlState::Aborting;
  given_up_at_ = now;
  links_.process.makeSafe(now);
  links_.controller.cancel();
}

DriveStatus DriveSession::status() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return status_;
}

}  // namespace lamina
