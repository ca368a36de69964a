// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/emulator/emulated_motion.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace lamina {
namespace {

// Firmware waits this long for company before it begins a lone block [s].
constexpr double kFirstBlockDelay = 0.1;
constexpr double kShortest = 1e-9;  // mm

}  // namespace

Point3 ExecutedMotion::positionAt(double time_s) const {
  const double whole = profile.distanceAt(end_s - start_s);
  if (!(whole > 0.0)) return end;
  const double part = profile.distanceAt(std::clamp(time_s, start_s, end_s) - start_s) / whole;
  return start + part * (end - start);
}

double ExecutedMotion::timeAt(double part) const {
  const double gone = std::clamp(part, 0.0, 1.0) * profile.distanceAt(end_s - start_s);
  const double a = profile.acceleration_mm_s2;
  const double ramp_up_s = (profile.cruise_mm_s - profile.entry_mm_s) / a;
  const double ramp_up = 0.5 * (profile.entry_mm_s + profile.cruise_mm_s) * ramp_up_s;
  const double ramp_down =
      0.5 * (profile.cruise_mm_s + profile.exit_mm_s) * (profile.cruise_mm_s - profile.exit_mm_s) / a;
  const double cruise = profile.length_mm - ramp_up - ramp_down;
  double passed = 0.0;
  if (gone < ramp_up) {
    passed = (std::sqrt(profile.entry_mm_s * profile.entry_mm_s + 2.0 * a * gone) - profile.entry_mm_s) / a;
  } else if (gone < ramp_up + cruise) {
    passed = ramp_up_s + (gone - ramp_up) / profile.cruise_mm_s;
  } else {
    const double left = std::max(profile.length_mm - gone, 0.0);
    passed = profile.duration_s -
             (std::sqrt(profile.exit_mm_s * profile.exit_mm_s + 2.0 * a * left) - profile.exit_mm_s) / a;
  }
  return std::clamp(start_s + passed, start_s, end_s);
}

EmulatedMotion::EmulatedMotion(const MotionLimits& limits, std::size_t capacity, Observer observer)
    : limits_(limits), capacity_(std::max<std::size_t>(capacity, 1)), observer_(std::move(observer)) {}

MotionSegment EmulatedMotion::segmentOf(const RequestedMotion& motion) const {
  MotionSegment segment;
  const Point3 way = motion.end - motion.start;
  const double length = way.norm();
  const bool is_in_place = length < kShortest;
  segment.length_mm = is_in_place ? std::abs(motion.filament_mm) : length;
  if (!is_in_place) segment.direction = way / length;
  segment.feed_mm_s = motion.feed_mm_s;
  const bool deposits = !is_in_place && motion.filament_mm > 0.0;
  segment.acceleration_mm_s2 = deposits ? limits_.acceleration_mm_s2 : limits_.travel_acceleration_mm_s2;
  return segment;
}

void EmulatedMotion::add(const RequestedMotion& motion, double now_s) {
  Block block{motion, segmentOf(motion), 0.0, 0.0};
  if (block.segment.length_mm < kShortest) return;
  if (isEmpty()) {
    begin_at_ = now_s + kFirstBlockDelay;
  } else if (!waiting_.empty()) {
    const double speed = junctionSpeed(last_segment_, block.segment, limits_.junction_deviation_mm);
    block.entry_limit2 = speed * speed;
  }
  last_segment_ = block.segment;
  waiting_.push_back(std::move(block));
  plan();
  if (!running_ && isFull()) begin_at_ = std::min(begin_at_, now_s);
}

/// Entry speeds from which the nozzle can still stop after the last block, and which it can reach. The entry
/// of the first block is the exit of the running one and stays.
void EmulatedMotion::plan() {
  double exit2 = 0.0;
  for (std::size_t i = waiting_.size(); i-- > 1;) {
    Block& block = waiting_[i];
    const double brake2 = exit2 + 2.0 * block.segment.acceleration_mm_s2 * block.segment.length_mm;
    block.entry2 = std::min(block.entry_limit2, brake2);
    exit2 = block.entry2;
  }
  for (std::size_t i = 0; i + 1 < waiting_.size(); ++i) {
    const Block& block = waiting_[i];
    const double reach2 = block.entry2 + 2.0 * block.segment.acceleration_mm_s2 * block.segment.length_mm;
    waiting_[i + 1].entry2 = std::min(waiting_[i + 1].entry2, reach2);
  }
}

void EmulatedMotion::begin(double at_s) {
  const Block block = std::move(waiting_.front());
  waiting_.pop_front();
  const double exit2 = waiting_.empty() ? 0.0 : waiting_.front().entry2;
  ExecutedMotion motion;
  motion.start = block.motion.start;
  motion.end = block.motion.end;
  motion.filament_mm = block.motion.filament_mm;
  motion.start_s = at_s;
  motion.profile = speedProfile(block.segment, std::sqrt(block.entry2), std::sqrt(exit2));
  motion.end_s = at_s + motion.profile.duration_s;
  running_ = motion;
}

void EmulatedMotion::end() {
  const ExecutedMotion ended = *running_;
  running_.reset();
  position_ = ended.end;
  filament_mm_ += ended.filament_mm;
  if (observer_) observer_(ended);
  if (waiting_.empty()) {
    ++starvations_;
  } else {
    begin(ended.end_s);
  }
}

void EmulatedMotion::advance(double now_s) {
  if (!running_ && !waiting_.empty() && begin_at_ <= now_s) begin(begin_at_);
  while (running_ && running_->end_s <= now_s) end();
}

std::optional<double> EmulatedMotion::nextEvent() const {
  if (running_) return running_->end_s;
  if (!waiting_.empty()) return begin_at_;
  return std::nullopt;
}

void EmulatedMotion::quickStop(double now_s) {
  advance(now_s);
  waiting_.clear();
  if (!running_) return;
  ExecutedMotion cut = *running_;
  const double whole = cut.profile.length_mm;
  const double gone = cut.profile.distanceAt(now_s - cut.start_s);
  cut.end = cut.positionAt(now_s);
  cut.end_s = std::max(now_s, cut.start_s);
  if (whole > 0.0) cut.filament_mm *= gone / whole;
  running_ = cut;
  end();
}

Point3 EmulatedMotion::positionAt(double now_s) const {
  return running_ ? running_->positionAt(now_s) : position_;
}

}  // namespace lamina
