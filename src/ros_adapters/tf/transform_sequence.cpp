// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tf/transform_sequence.hpp"

#include <ros/console.h>
#include <tf2/exceptions.h>

#include <algorithm>
#include <utility>

#include "names.hpp"

namespace lamina {
namespace {

constexpr double kRemembered = 30.0;  // s, by the stamps, that the buffer looks back
constexpr double kQuiet = 10.0;       // s between complaints
// By which ROS time goes back so that all begins anew: less is made up for at once.
const ros::Duration kBack(0.5);

/// Whether a stamp is so far ahead of another that the buffer would forget what it has of that time.
bool isFarAhead(const ros::Time& stamp, const ros::Time& latest) {
  return stamp.toNSec() > latest.toNSec() + static_cast<std::uint64_t>(kRemembered * 1e9);
}

}  // namespace

TransformSequence::TransformSequence(std::size_t most_waiting)
    : most_waiting_(most_waiting), buffer_(ros::Duration(kRemembered)) {}

void TransformSequence::add(const geometry_msgs::TransformStamped& transform, const std::string& authority) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (isOfTimeBefore(transform.header.stamp)) return;
  ++received_;
  keepFrames(transform);
  for (Waiting& each : believed({transform, authority})) {
    const ros::Time stamp = each.transform.header.stamp;
    waiting_.insert({stamp, std::move(each)});
  }
  while (waiting_.size() > most_waiting_) {
    ++forced_;
    notePassed(waiting_.begin()->first);
    give(waiting_.begin()->second);
    waiting_.erase(waiting_.begin());
  }
}

/// Whether a stamp is of the time from which ROS time has gone back; all that was received is, when it does.
bool TransformSequence::isOfTimeBefore(const ros::Time& stamp) {
  if (!ros::Time::isValid()) return false;  // of a bag, read without a clock
  const ros::Time now = ros::Time::now();
  if (now + kBack < now_) {
    ROS_WARN("ROS time went back by %.3f s: the transforms received so far are forgotten",
             (now_ - now).toSec());
    went_back_ = now_;
    waiting_.clear();
    clocks_.clear();
    passed_.clear();
    taken_ = ros::Time();
    buffer_.clear();
    ++restarts_;
  }
  now_ = now;
  return now < went_back_ && stamp > now + kBack;
}

void TransformSequence::drop(const Waiting& ahead) {
  if (!ros::Time::isValid()) return;  // of a bag, read without a clock
  ROS_WARN_THROTTLE(kQuiet, "transform from %s to %s left out: its stamp, %.3f s, is far ahead of the others",
                    ahead.transform.header.frame_id.c_str(), ahead.transform.child_frame_id.c_str(),
                    ahead.transform.header.stamp.toSec());
}

/// Those of a frame whose stamps are no longer in doubt: two in turn that are ahead are so for a pause.
std::vector<TransformSequence::Waiting> TransformSequence::believed(Waiting next) {
  FrameClock& clock = clocks_[bareFrame(next.transform.child_frame_id)];
  const ros::Time stamp = next.transform.header.stamp;
  std::vector<Waiting> result;
  result.reserve(2);
  if (clock.ahead && isFarAhead(stamp, clock.latest) && clock.ahead->transform.header.stamp < stamp) {
    clock.latest = clock.ahead->transform.header.stamp;
    result.push_back(*std::exchange(clock.ahead, std::nullopt));
  }
  if (clock.ahead && clock.ahead->transform.header.stamp != stamp) drop(*clock.ahead);
  clock.ahead.reset();
  if (!clock.latest.isZero() && isFarAhead(stamp, clock.latest)) {
    clock.ahead = std::move(next);
    return result;
  }
  clock.latest = std::max(clock.latest, stamp);
  result.push_back(std::move(next));
  return result;
}

void TransformSequence::addFixed(const geometry_msgs::TransformStamped& transform,
                                 const std::string& authority) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++received_;
    keepFrames(transform);
  }
  try {
    buffer_.setTransform(transform, authority, true);
  } catch (const tf2::TransformException& error) {
    ROS_ERROR_THROTTLE(kQuiet, "fixed transform ignored: %s", error.what());
  }
}

void TransformSequence::keepFrames(const geometry_msgs::TransformStamped& transform) {
  frames_.insert(bareFrame(transform.header.frame_id));
  frames_.insert(bareFrame(transform.child_frame_id));
}

bool TransformSequence::knows(const std::string& frame) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return frames_.count(bareFrame(frame)) > 0;
}

Readiness TransformSequence::passTo(const std::string& frame, const ros::Time& stamp) {
  while (isNextUpTo(stamp)) passNext();
  Readiness ready = readiness(buffer_, names::kBedFrame, frame, stamp);
  // Transforms of a frame that nobody names would be looked for to the end of them all.
  while (ready == Readiness::NotYet && knows(frame) && passNext())
    ready = readiness(buffer_, names::kBedFrame, frame, stamp);
  return ready;
}

bool TransformSequence::isNextUpTo(const ros::Time& stamp) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return !waiting_.empty() && waiting_.begin()->first <= stamp;
}

bool TransformSequence::passNext() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (waiting_.empty()) return false;
  const ros::Time stamp = waiting_.begin()->first;
  const auto [begin, end] = waiting_.equal_range(stamp);
  for (auto it = begin; it != end; ++it) give(it->second);
  waiting_.erase(begin, end);
  notePassed(stamp);
  return true;
}

void TransformSequence::notePassed(const ros::Time& stamp) {
  passed_.insert(stamp);
  // One that is far ahead of all others makes none of them old.
  const ros::Time lately = std::min(stamp, std::exchange(given_, stamp));
  const auto remembered = static_cast<std::uint64_t>(ros::Duration(kRemembered).toNSec());
  while (passed_.begin()->toNSec() + remembered < lately.toNSec()) passed_.erase(passed_.begin());
}

void TransformSequence::give(const Waiting& waiting) {
  try {
    buffer_.setTransform(waiting.transform, waiting.authority, false);
  } catch (const tf2::TransformException& error) {
    ROS_ERROR_THROTTLE(kQuiet, "transform from %s to %s ignored: %s",
                       waiting.transform.header.frame_id.c_str(), waiting.transform.child_frame_id.c_str(),
                       error.what());
  }
}

std::vector<StampedNozzle> TransformSequence::takeNozzles() {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<StampedNozzle> nozzles;
  while (!passed_.empty()) {
    const ros::Time stamp = *passed_.begin();
    if (stamp <= taken_) {
      passed_.erase(passed_.begin());
      continue;
    }
    const auto bed_from_nozzle = lookUp(buffer_, names::kBedFrame, names::kNozzleFrame, stamp);
    // Other transforms of that stamp may still wait.
    const bool is_whole = waiting_.empty() || waiting_.begin()->first > stamp;
    if (!is_whole || (!bed_from_nozzle &&
                      readiness(buffer_, names::kBedFrame, names::kNozzleFrame, stamp) == Readiness::NotYet))
      break;
    passed_.erase(passed_.begin());
    taken_ = stamp;
    if (bed_from_nozzle) nozzles.push_back({stamp, *bed_from_nozzle});
  }
  return nozzles;
}

std::size_t TransformSequence::untaken() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return passed_.size();
}

std::uint64_t TransformSequence::forced() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return forced_;
}

std::uint64_t TransformSequence::restarts() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return restarts_;
}

std::uint64_t TransformSequence::received() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return received_;
}

}  // namespace lamina
