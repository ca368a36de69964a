// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "drive_session.hpp"
#include "lamina/base/number_text.hpp"
#include "stamps.hpp"

#include <ros/console.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lamina {
namespace {

constexpr double kSettling = 0.2;    // s for which joints must be still
constexpr double kCoarser = 10.0;    // tolerance on the tip on the way to the start, that is run fast
constexpr double kShortOf = 0.995;   // of a share, that is reported
constexpr double kSame = 1e-6;       // mm or rad: joints that have not been moved
constexpr double kLonger = 2.0;      // what took a time may take that much more of it
constexpr double kPatience = 5.0;    // s that a controller may need to stop by itself
constexpr double kResumeLook = 0.5;  // s for which a service waits for joints

/// With nothing of the process on, more than the planned speed harms no bead.
TrajectoryFeederSettings feedingOf(const DriveMotion& motion, const DriverSettings& settings) {
  TrajectoryFeederSettings feeding = settings.feeder;
  if (motion.process == ProcessUse::Off) feeding.feed_most = boundsOf(OverrideKind::Feed).most;
  return feeding;
}

}  // namespace

DriveSession::DriveSession(const DriveMotion& motion, const KinematicModel& model,
                           const DriverSettings& settings, const DriveLinks& links)
    : motion_(motion),
      model_(model),
      settings_(settings),
      feeding_(feedingOf(motion, settings)),
      links_(links),
      feeder_(motion.path, feeding_, motion.from_mm),
      tracking_(model),
      reports_(settings.tracking, settings.controller_wait_s, ros::Time()) {
  links_.controller.begin();
  status_.feeding.least_queued_s = std::numeric_limits<double>::infinity();
  status_.state = motion.running;
  status_.laid_mm = isDry() ? 0.0 : feeder_.laidAt(0.0).length_mm;
  laid_mm3_ = feeder_.laidAt(0.0).volume_mm3;
  if (motion_.correction) wait_.emplace(feeder_, *motion_.correction, settings_.loop.wait_s);
}

bool DriveSession::step() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (isFinal(status_.state)) return false;
  const DriveInstant present = links_.clock();
  const ros::Time now = followTime(present);
  watchClock(present);
  begin(now);
  watch(now);
  awaitMap(now);
  feed(now);
  follow(now);
  return advance(now);
}

/// The clock of the points starts as the first of them are sent, whatever came before.
void DriveSession::begin(const ros::Time& now) {
  if (!begin_.isZero()) return;
  begin_ = now + ros::Duration(settings_.start_delay_s);
  expectReports(begin_);
}

/// The times of all points are those of a clock that only goes on; where it is set back by little it stands.
ros::Time DriveSession::followTime(const DriveInstant& present) {
  const ros::Time now = present.ros;
  const ros::Time before = stepped_;
  if (now < before && (before - now).toSec() <= kSetBack) return before;
  stepped_ = now;
  if (now < before)
    giveUp(now,
           {ErrorCode::DeviceError, "ROS time went back by " + numberText((before - now).toSec()) +
                                        " s; expected it to go on, for the controller follows points by it"});
  return now;
}

/// Once ROS time is set, each chunk's process is followed by the new time, but a controller in motion joins
/// its points to those that it follows by the old one.
void DriveSession::watchClock(const DriveInstant& present) {
  if (given_up_at_ || !present.steady_s) return;
  // A machine that is held has no points whose time could change.
  if (!first_step_ || status_.state == PackmlState::Held) first_step_ = present;
  const double passed_s = *present.steady_s - *first_step_->steady_s;
  const double ahead_s = secondsBetween(first_step_->ros, present.ros) - passed_s;
  if (std::abs(ahead_s) <= kSetBack) return;
  giveUp(present.ros, {ErrorCode::DeviceError,
                       "ROS time was set " + std::string(ahead_s > 0.0 ? "on" : "back") + " by " +
                           numberText(std::abs(ahead_s)) + " s; expected at most " + numberText(kSetBack) +
                           " s, for motion and process would no longer be in step"});
}

/// The controller's clock: by stamps that of its last report, which a slow host does not drive on [s].
double DriveSession::controllerTime(const ros::Time& now) const {
  if (!isByStamps()) return jobTime(now);
  const std::lock_guard<std::mutex> lock(report_mutex_);
  return reported_.isZero() ? -settings_.start_delay_s : secondsBetween(begin_, reported_);
}

/// The time of the job when the controller's last report came [s]: what it does since is not known.
double DriveSession::heardTime() const {
  const std::lock_guard<std::mutex> lock(report_mutex_);
  return heard_.isZero() ? -settings_.start_delay_s : secondsBetween(begin_, heard_);
}

/// Whether what is planned is over. By stamps only the controller knows.
bool DriveSession::isRun(const ros::Time& now) const {
  return jobTime(now) >= feeder_.restTime() && (!isByStamps() || links_.controller.isDone());
}

/// Stops if the controller does, says nothing, or leaves the path.
void DriveSession::watch(const ros::Time& now) {
  if (given_up_at_) return;
  if (const std::optional<std::string> failure = links_.controller.failure())
    return giveUp(now, {ErrorCode::DeviceError, *failure});
  const bool is_way_to_start = motion_.running == PackmlState::Starting;
  const double most_mm = settings_.tracking.tip_mm * (is_way_to_start ? kCoarser : 1.0);
  std::optional<std::string> silence, deviation;
  {
    const std::lock_guard<std::mutex> lock(report_mutex_);
    silence = reports_.look(now);
    deviation = tracking_.deviation(most_mm);
  }
  const bool is_moving = jobTime(now) > 0.0 && !isRun(now);
  if (is_moving && silence) return giveUp(now, {ErrorCode::Disconnected, *silence});
  if (deviation && status_.state != PackmlState::Aborting)
    brake(now, {ErrorCode::DeviceError, *deviation}, Lift::No);
}

/// Whether the controller has come to the end of what it has while the motion was to go on: the points that
/// follow are past, and it would leap to the first one that is not. By stamps its clock waits for them.
bool DriveSession::hasRunDry(const ros::Time& now) const {
  const double now_s = jobTime(now);
  if (isByStamps() || fed_s_ <= 0.0 || now_s <= fed_s_) return false;
  const JointValues missed = feeder_.at(now_s).position - feeder_.at(fed_s_).position;
  return missed.cwiseAbs().maxCoeff() > kSame;
}

void DriveSession::feed(const ros::Time& now) {
  if (given_up_at_) return;
  if (feeder_.state() == TrajectoryFeederState::Running && !feeder_.isHeld() && fed_s_ > 0.0) {
    const double queued_s = std::max(0.0, fed_s_ - controllerTime(now));
    status_.feeding.least_queued_s = std::min(status_.feeding.least_queued_s, queued_s);
    if (queued_s == 0.0 && !was_starved_) ++status_.feeding.starvations;
    was_starved_ = queued_s == 0.0;
  }
  if (hasRunDry(now))
    return giveUp(now, {ErrorCode::DeviceError,
                        "the controller had nothing left to follow for " + numberText(jobTime(now) - fed_s_) +
                            " s amid the motion; expected it to be fed at least " +
                            numberText(feeding_.ahead_s) + " s ahead (feeder.ahead_s)"});
  while (std::optional<TrajectoryChunk> chunk = feeder_.next(jobTime(now))) {
    if (motion_.correction) {
      chunk = motion_.correction->corrected(std::move(*chunk));
      const std::string refusal = motion_.correction->takeRefusal();
      if (!refusal.empty()) ROS_WARN("a height is not followed: %s", refusal.c_str());
    }
    // First what is to happen on the way, then the way.
    links_.process.send(*chunk, begin_, motion_.toolpath_id, motion_.process);
    links_.controller.send(*chunk, begin_);
    fed_s_ = chunk->points.back().time_s;
    fed_to_ = chunk->points.back().position;
  }
}

void DriveSession::awaitMap(const ros::Time& now) {
  if (!wait_ || status_.state != PackmlState::Execute || given_up_at_) return;
  const bool is_at_rest = isAtRest(now);
  if (wait_->look(jobTime(now), is_at_rest ? MapWait::Motion::Rests : MapWait::Motion::Moves)) {
    if (is_at_rest) expectReports(now);
    fed_s_ = 0.0;  // at rest nothing is missing
  }
  const std::string notice = wait_->takeNotice();
  if (!notice.empty()) ROS_WARN("%s", notice.c_str());
}

std::string DriveSession::offer(const lamina_msgs::ToolpathConstPtr& plan) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return wait_ ? wait_->offer(plan) : "the machine is on its way to the start";
}

lamina_msgs::ToolpathConstPtr DriveSession::plan() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return duePlan(links_.clock().ros);
}

lamina_msgs::ToolpathConstPtr DriveSession::duePlan(const ros::Time& now) const {
  const bool is_due =
      wait_ && status_.state == PackmlState::Execute && !given_up_at_ && feeder_.isHeld() && isAtRest(now);
  return is_due ? wait_->plan() : nullptr;
}

void DriveSession::refuse(const std::string& plan_id, const std::string& reason) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (wait_) wait_->refuse(plan_id, reason);
}

bool DriveSession::leaveFor(const std::string& plan_id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const lamina_msgs::ToolpathConstPtr due = duePlan(links_.clock().ros);
  is_left_ = due && due->id == plan_id;
  return is_left_;
}

bool DriveSession::isAtRest(const ros::Time& now) const {
  return run_at_ && (now - *run_at_).toSec() >= kSettling;
}

void DriveSession::measureLaid(double time_s) {
  if (isDry()) return;
  const LaidAmount laid = feeder_.laidAt(time_s);
  status_.laid_mm = std::max(status_.laid_mm, laid.length_mm);
  status_.used_mm3 += std::max(0.0, laid.volume_mm3 - laid_mm3_) * status_.flow_share;
  laid_mm3_ = std::max(laid_mm3_, laid.volume_mm3);
}

void DriveSession::follow(const ros::Time& now) {
  if (given_up_at_) return;
  // By what the controller has reported where its clock counts: what was laid is not to be told too early.
  measureLaid(std::min({jobTime(now), controllerTime(now), heardTime(), off_s_}));
  const double now_s = jobTime(now);
  const double rest_s = feeder_.restTime();
  status_.time_s = std::clamp(now_s, 0.0, rest_s);
  const TrajectoryFeederState state = feeder_.state();
  if (state == TrajectoryFeederState::Running || state == TrajectoryFeederState::Finished)
    status_.duration_s = rest_s;
  const JointState wanted = feeder_.at(status_.time_s);
  status_.heading_for = wanted.heading_for;
  status_.tip_speed_mm_s = wanted.tip_speed_mm_s;
  status_.handed_over_for = fed_s_ > 0.0 ? feeder_.at(fed_s_).heading_for : wanted.heading_for;
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
  if (!isRun(now))
    run_at_.reset();
  else if (!run_at_)
    run_at_ = isByStamps() ? now : begin_ + ros::Duration(feeder_.restTime());
  const bool is_at_rest = isAtRest(now);
  const bool is_planned_end =
      feeder_.state() == TrajectoryFeederState::Finished && jobTime(now) >= feeder_.restTime();
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
      if (!is_planned_end) return true;
      status_.state = PackmlState::Completing;
      if (motion_.correction) motion_.correction->end();
      return true;
    default:  // Starting or Completing
      if (!is_planned_end) return true;
      if (!is_at_rest || !links_.controller.isDone()) return awaitEnd(now);
      measureLaid(feeder_.restTime());
      status_.state = PackmlState::Complete;
      return false;
  }
}

/// The motion is done once the controller says so. Goes on, but not for ever.
bool DriveSession::awaitEnd(const ros::Time& now) {
  const double overdue_s = controllerTime(now) - feeder_.restTime();
  if (overdue_s > std::max(settings_.tracking.silence_s, kSettling))
    giveUp(now, {ErrorCode::TimedOut, "the controller has not come to the end of its last goal " +
                                          numberText(overdue_s) + " s after it was due"});
  return true;
}

std::string DriveSession::correct(const CorrectionMap& map, const std::string& digest) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return motion_.correction ? motion_.correction->hear(map, digest)
                            : "the machine is on its way to the start";
}

std::vector<DrivenLayer> DriveSession::takeLayers() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return motion_.correction ? motion_.correction->takeLayers() : std::vector<DrivenLayer>();
}

void DriveSession::hear(const ControllerReport& report, const ros::Time& now) {
  const std::lock_guard<std::mutex> lock(report_mutex_);
  reported_ = std::max(reported_, report.stamp);
  heard_ = std::max(heard_, now);
  reports_.hear(report.stamp, now);
  tracking_.add(report.wanted, report.actual);
}

/// A controller at rest reports nothing.
void DriveSession::expectReports(const ros::Time& from) {
  const std::lock_guard<std::mutex> lock(report_mutex_);
  reports_.restart(from);
}

std::optional<std::string> DriveSession::pause() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const ros::Time now = links_.clock().ros;
  begin(now);
  if (is_left_) return std::string("the machine goes over to the layers left as planned anew");
  if (status_.state != PackmlState::Execute)
    return std::string("state is ") + toString(status_.state) + "; only Execute can be paused";
  feeder_.pause(jobTime(now));
  if (feeder_.state() != TrajectoryFeederState::Paused)
    return std::string("the motion ends before it could be paused");
  status_.state = PackmlState::Holding;
  feed(now);
  return std::nullopt;
}

/// Why a motion that is held cannot go on from where the joints are; empty if it can. Looked at unlocked, for
/// reports are waited for.
std::string DriveSession::displacement() const {
  JointValues place;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (status_.state != PackmlState::Held) return {};
    place = fed_to_;
  }
  if (place.size() == 0) return {};
  const TrackingLimits& limits = settings_.tracking;
  try {
    return links_.joints.refusalAt(place, limits.tip_mm, limits.silence_s, {kResumeLook});
  } catch (const Error& error) {
    return error.what();
  }
}

std::optional<std::string> DriveSession::resume() {
  const std::string displaced = displacement();
  const std::lock_guard<std::mutex> lock(mutex_);
  const ros::Time now = links_.clock().ros;
  if (status_.state != PackmlState::Held)
    return std::string("state is ") + toString(status_.state) + "; only Held can be resumed";
  if (!displaced.empty()) return displaced;
  if (wait_)
    wait_->resume(jobTime(now));
  else
    feeder_.resume(jobTime(now));
  if (!isRun(now)) run_at_.reset();
  expectReports(now);
  fed_s_ = 0.0;  // at rest nothing is missing
  status_.state = PackmlState::Unholding;
  feed(now);
  return std::nullopt;
}

bool DriveSession::isChangeable() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const PackmlState state = status_.state;
  return !is_left_ && !given_up_at_ &&
         (state == PackmlState::Execute || state == PackmlState::Holding || state == PackmlState::Held ||
          state == PackmlState::Unholding);
}

bool DriveSession::setShare(OverrideKind kind, double share) {
  if (kind == OverrideKind::Feed) return setSpeed(share);
  if (motion_.running == PackmlState::Starting) return true;  // the process is off
  if (isDry()) throw InvalidInput(std::string("a dry run has no ") + nameOf(kind) + "; expected feed");
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_left_ || given_up_at_ || isFinal(status_.state)) return true;
  const ros::Time now = links_.clock().ros;
  begin(now);
  feeder_.setShare(kind, share, jobTime(now));
  (kind == OverrideKind::Flow ? status_.flow_share : status_.power_share) = share;
  feed(now);
  return true;
}

bool DriveSession::setSpeed(double share) {
  if (motion_.running == PackmlState::Starting) share = std::min(share, 1.0);
  std::uint64_t order = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    order = ++speed_orders_;
  }
  // Long toolpaths take their time, in which the controller is fed on, and a later order may be ready first.
  const SpeedChange change = feeder_.speedChange(share);
  if (change.reached < kShortOf * share)
    ROS_WARN(
        "the limits of joints and path let the motion take %.4g of the planned speeds on average, not %.4g",
        change.reached, share);
  double later_s = 0.0;
  for (;;) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (order != speed_orders_) return false;
    if (is_left_ || given_up_at_ || isFinal(status_.state)) return true;
    const ros::Time before = links_.clock().ros;
    begin(before);
    const auto clock = [this] { return jobTime(links_.clock().ros); };
    const bool is_set = feeder_.setSpeed(change, jobTime(before) + later_s, clock);
    // What is changed must not be past once it is sent; meanwhile the controller needs what it has.
    const ros::Time now = links_.clock().ros;
    if (is_set) {
      status_.feed_share = share;
      status_.reached_share = change.reached;
    }
    feed(now);
    if (is_set) return true;
    later_s = kLonger * (now - before).toSec();
  }
}

void DriveSession::abort(const Failure& why) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const ros::Time now = links_.clock().ros;
  if (isFinal(status_.state) || status_.state == PackmlState::Aborting || is_left_) return;
  begin(now);
  if (isAtRest(now)) expectReports(now);
  // What does not move yet does not begin to, and nothing was looked for on the way of a lift.
  const bool has_moved = jobTime(now) > 0.0;
  brake(now, why, has_moved && settings_.lift_mm > 0.0 ? Lift::Yes : Lift::No);
}

void DriveSession::brake(const ros::Time& now, const Failure& why, Lift lift) {
  status_.state = PackmlState::Aborting;
  status_.failure = why;
  const double now_s = jobTime(now);
  off_s_ = std::min(off_s_, now_s);
  try {
    if (lift == Lift::Yes)
      feeder_.abort(now_s, {settings_.lift_mm, settings_.lift_mm_s}, model_);
    else
      feeder_.abort(now_s);
  } catch (const Unreachable& error) {
    status_.failure.message += "; the tool was not lifted: " + std::string(error.what());
  }
  feed(now);
}

/// The controller is to stop by itself: nothing more is sent to it.
void DriveSession::giveUp(const ros::Time& now, const Failure& why) {
  if (status_.failure.code == ErrorCode::Ok) status_.failure = why;
  status_.state = PackmlState::Aborting;
  given_up_at_ = now;
  links_.process.makeSafe(now);
  links_.controller.cancel();
}

void DriveSession::leave(const Failure& why) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (isFinal(status_.state) || is_left_) return;
  giveUp(links_.clock().ros, why);
  status_.state = PackmlState::Aborted;
}

DriveStatus DriveSession::status() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return status_;
}

}  // namespace lamina
