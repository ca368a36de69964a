// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/servo/cyclic_player.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "lamina/kinematics/model/joint_limits.hpp"
#include "lamina/trajectory/joint_braking.hpp"
#include "lamina/trajectory/joint_cubic.hpp"

namespace lamina {
namespace {

constexpr double kStill = 1e-9;       // mm/s, rad/s: numbers that stand for none
constexpr double kSameTime = 1e-9;    // s
constexpr double kStepMargin = 1.1;   // of the way that a joint may go in a cycle
constexpr double kLimitSlack = 1e-3;  // mm, rad or a share: what rounding leaves

}  // namespace

std::string faultText(const CyclicFault& fault, const std::vector<DrivenJoint>& joints) {
  const std::string value = numberText(fault.value);
  const std::string most = numberText(fault.most);
  switch (fault.kind) {
    case CyclicFault::Kind::Starved:
      return "no more points came: those there are end in motion after " + value + " s; expected more " +
             most + " s before";
    case CyclicFault::Kind::Late:
      return "a cycle came " + value + " s late; expected " + most + " s at most";
    case CyclicFault::Kind::Step:
      return "joint '" + joints.at(fault.joint).name + "' was to go " + value + " in one step; expected " +
             most + " at most";
  }
  return "";
}

CyclicPlayer::CyclicPlayer(std::vector<DrivenJoint> joints, const CyclicSettings& settings,
                           const CyclicSink& sink)
    : joints_(std::move(joints)),
      settings_(settings),
      cycle_s_(sink.cycle()),
      ahead_s_(sink.ahead()),
      tolerance_(toRadians(settings.start_tolerance_deg)) {
  CyclicSettings checked = settings;
  SettingsSchema schema;
  describe(schema, checked);
  schema.validate();
  begin(JointValues::Zero(static_cast<Eigen::Index>(joints_.size())));
}

void CyclicPlayer::begin(const JointValues& position) {
  points_.clear();
  brake_.reset();
  fault_.reset();
  is_brake_requested_ = false;
  last_due_s_.reset();
  passed_ = 0;
  target_.cycle = 0;
  target_.now = target_.ahead = {position, JointValues::Zero(position.size())};
}

bool CyclicPlayer::isMoving(const Point& point) const {
  return point.velocity.cwiseAbs().maxCoeff() > kStill;
}

void CyclicPlayer::requireFeasible(const TrajectoryChunk& chunk) const {
  if (chunk.points.empty()) throw InvalidInput("a motion without points; expected one at least");
  for (std::size_t i = 1; i < chunk.points.size(); ++i)
    if (!(chunk.points[i].time_s > chunk.points[i - 1].time_s))
      throw InvalidInput("point " + std::to_string(i) + " is not later than the one before");
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const DrivenJoint& joint = joints_[j];
    const auto i = static_cast<Eigen::Index>(j);
    const double fastest = joint.max_speed * (1.0 + kLimitSlack);
    for (const JointState& point : chunk.points) {
      if (!(point.position[i] >= joint.low - kLimitSlack && point.position[i] <= joint.high + kLimitSlack))
        throw InvalidInput("a point is at " + boundsText(joint, point.position[i], joint.low, joint.high));
      if (!(std::abs(point.velocity[i]) <= fastest))
        throw InvalidInput("a point has the speed of " +
                           boundsText(joint, point.velocity[i], -fastest, fastest));
    }
  }
}

/// The motion goes on from what is planned, or from where the robot rests, and can still be joined.
void CyclicPlayer::requireJoined(const TrajectoryChunk& chunk, double now_s) const {
  if (brake_ || is_brake_requested_)
    throw InvalidInput("the robot is being braked; expected a motion from rest");
  const JointState& first = chunk.points.front();
  if (!(chunk.points.back().time_s > now_s))
    throw InvalidInput("the last point is " + numberText(now_s - chunk.points.back().time_s) +
                       " s in the past; expected one that is still to come");
  if (!points_.empty() && isMoving(points_.back()) && first.time_s > points_.back().time_s + kSameTime)
    throw InvalidInput("the first point is " + numberText(first.time_s - points_.back().time_s) +
                       " s behind the end of the motion; expected one within it");
  const JointValues planned = points_.empty() ? target_.now.position : onPoints(first.time_s).position;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const auto i = static_cast<Eigen::Index>(j);
    if (std::abs(first.position[i] - planned[i]) <= tolerance_) continue;
    throw InvalidInput(
        "the first point is not where the robot is: " +
        boundsText(joints_[j], first.position[i], planned[i] - tolerance_, planned[i] + tolerance_));
  }
}

void CyclicPlayer::accept(const TrajectoryChunk& chunk, double now_s) {
  requireFeasible(chunk);
  requireJoined(chunk, now_s);
  const double first_s = chunk.points.front().time_s;
  std::vector<Point> merged;
  merged.reserve(points_.size() - passed_ + chunk.points.size() + 1);
  for (std::size_t i = passed_; i < points_.size() && points_[i].time_s < first_s - kSameTime; ++i)
    merged.push_back(points_[i]);
  const bool was_at_rest = points_.empty();
  if (was_at_rest && now_s < first_s - kSameTime)
    merged.push_back({now_s, target_.now.position, JointValues::Zero(target_.now.position.size())});
  for (const JointState& point : chunk.points)
    merged.push_back({point.time_s, point.position, point.velocity});
  merged.swap(points_);
  const std::size_t former_passed = std::exchange(passed_, 0);
  // What would be given next has to be within a step of what was given last.
  const double next_s = last_due_s_ ? std::max(*last_due_s_ + cycle_s_, now_s) : now_s;
  if (const auto too_far = tooFar(onPoints(next_s), last_due_s_ ? next_s - *last_due_s_ : cycle_s_)) {
    merged.swap(points_);
    passed_ = former_passed;
    throw InvalidInput("the motion cannot be joined in time: " + faultText(*too_far, joints_));
  }
  if (was_at_rest) fault_.reset();
}

JointTarget CyclicPlayer::onPoints(double path_s) const {
  const auto later =
      std::upper_bound(points_.begin() + static_cast<std::ptrdiff_t>(passed_), points_.end(), path_s,
                       [](double time_s, const Point& point) { return time_s < point.time_s; });
  if (later == points_.end()) {
    const Point& last = points_.back();
    if (!isMoving(last)) return {last.position, JointValues::Zero(last.position.size())};
    return {last.position + (path_s - last.time_s) * last.velocity, last.velocity};
  }
  if (later == points_.begin()) return {later->position, JointValues::Zero(later->position.size())};
  const Point& from = *std::prev(later);
  return {cubicPosition(from, *later, path_s), cubicVelocity(from, *later, path_s)};
}

/// How fast the time of the points goes.
double CyclicPlayer::rateAt(double time_s) const {
  if (!brake_) return 1.0;
  const double braked_s = std::clamp(time_s - brake_->begin_s, 0.0, brake_->duration_s);
  return brake_->duration_s > 0.0 ? 1.0 - braked_s / brake_->duration_s : 0.0;
}

double CyclicPlayer::pathTime(double time_s) const {
  if (!brake_) return time_s;
  const double braked_s = std::clamp(time_s - brake_->begin_s, 0.0, brake_->duration_s);
  return brake_->path_s + 0.5 * (1.0 + rateAt(time_s)) * braked_s;
}

JointTarget CyclicPlayer::at(double time_s) const {
  if (points_.empty()) return {target_.now.position, JointValues::Zero(target_.now.position.size())};
  JointTarget target = onPoints(pathTime(time_s));
  if (brake_) target.velocity *= rateAt(time_s);
  return target;
}

/// How long braking takes from there on, for the fastest of the points on its way.
double CyclicPlayer::brakeTimeFrom(double path_s) const {
  double brake_s = brakeTime(onPoints(path_s).velocity, joints_, settings_.brake_s);
  for (std::size_t i = passed_; i < points_.size(); ++i) {
    if (points_[i].time_s < path_s) continue;
    if (points_[i].time_s > path_s + 0.5 * brake_s) return brake_s;
    brake_s = std::max(brake_s, brakeTime(points_[i].velocity, joints_, settings_.brake_s));
  }
  const Point& last = points_.back();
  if (!isMoving(last)) return brake_s;
  return std::min(
      brake_s, 2.0 * std::max(0.0, last.time_s - path_s) + brakeRoom(last.position, last.velocity, joints_));
}

void CyclicPlayer::startBraking(double time_s, double path_s) {
  brake_ = Brake{time_s, path_s, brakeTimeFrom(path_s)};
}

/// Begins to brake where it is commanded to, a cycle came too late, or the points soon end in motion.
void CyclicPlayer::watch(double newest_s, double late_s) {
  if (points_.empty() || brake_) return;
  if (is_brake_requested_) {
    const double last_s = last_due_s_.value_or(newest_s);
    return startBraking(last_s, last_s);
  }
  const double most_s = settings_.late_cycles * cycle_s_;
  if (late_s > most_s && points_.front().time_s <= newest_s) {
    fault_ = CyclicFault{CyclicFault::Kind::Late, 0, late_s, most_s};
    return startBraking(newest_s, newest_s);
  }
  const double left_s = points_.back().time_s - newest_s;
  if (!isMoving(points_.back()) || left_s > 0.5 * settings_.brake_s * (1.0 + kLimitSlack) + cycle_s_) return;
  const double needed_s = 0.5 * brakeTimeFrom(newest_s) + cycle_s_;
  if (left_s >= needed_s) return;
  fault_ = CyclicFault{CyclicFault::Kind::Starved, 0, left_s, needed_s};
  startBraking(newest_s, newest_s);
}

/// The joint that a target would take further than it may go in the time.
std::optional<CyclicFault> CyclicPlayer::tooFar(const JointTarget& asked, double elapsed_s) const {
  const JointValues way = (asked.position - target_.now.position).cwiseAbs();
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const double most = kStepMargin * joints_[j].max_speed * elapsed_s;
    const double is = way[static_cast<Eigen::Index>(j)];
    if (!(is <= most)) return CyclicFault{CyclicFault::Kind::Step, j, is, most};
  }
  return std::nullopt;
}

/// Straight on from the last target, no faster than joints go: the points lead where they cannot come to.
void CyclicPlayer::brakeStraight() {
  double share = 1.0;
  for (std::size_t j = 0; j < joints_.size(); ++j) {
    const double speed = std::abs(target_.now.velocity[static_cast<Eigen::Index>(j)]);
    if (speed > joints_[j].max_speed) share = std::min(share, joints_[j].max_speed / speed);
  }
  points_.resize(1);
  passed_ = 0;
  points_.front() = {*last_due_s_, target_.now.position, share * target_.now.velocity};
  startBraking(*last_due_s_, *last_due_s_);
}

const CyclicTarget* CyclicPlayer::advance(double due_s, double now_s) {
  const double late_s = std::max(0.0, now_s - due_s);
  const double newest_s = due_s + std::floor(late_s / cycle_s_) * cycle_s_;
  if (last_due_s_ && newest_s < *last_due_s_ + 0.5 * cycle_s_) return nullptr;
  const double elapsed_s = last_due_s_ ? newest_s - *last_due_s_ : cycle_s_;
  watch(newest_s, late_s);
  JointTarget asked = at(newest_s);
  const std::optional<CyclicFault> too_far = tooFar(asked, elapsed_s);
  if (too_far && last_due_s_) {
    fault_ = too_far;
    brakeStraight();
    asked = at(newest_s);
  }
  target_.cycle += std::llround(elapsed_s / cycle_s_);
  const JointTarget ahead = at(newest_s + ahead_s_);
  target_.now = asked;
  target_.ahead = ahead;
  last_due_s_ = newest_s;
  settle(newest_s);
  return &target_;
}

/// Leaves behind what has passed, and all of it once the motion is at rest.
void CyclicPlayer::settle(double time_s) {
  if (points_.empty()) return;
  const bool is_over = brake_ ? time_s >= brake_->begin_s + brake_->duration_s
                              : !isMoving(points_.back()) && time_s >= points_.back().time_s - kSameTime;
  if (is_over) {
    points_.clear();
    passed_ = 0;
    brake_.reset();
    is_brake_requested_ = false;
    return;
  }
  const double path_s = pathTime(time_s);
  while (passed_ + 1 < points_.size() && points_[passed_ + 1].time_s <= path_s) ++passed_;
}

}  // namespace lamina
