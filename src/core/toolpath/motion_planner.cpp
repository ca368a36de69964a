// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/motion_planner.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr std::size_t kFirstLook = 32;
constexpr double kSurely = 1.0 + 1e-9;  // beyond rounding

double squared(double value) { return value * value; }

/// Squared speed that braking or accelerating over the whole segment adds [mm²/s²].
double gain2(const MotionSegment& segment) { return 2.0 * segment.acceleration_mm_s2 * segment.length_mm; }

[[noreturn]] void refuse(double value, const char* what, const char* unit) {
  throw InvalidInput(std::string(what) + " of a motion is " + numberText(value) + " " + unit +
                     "; must be positive");
}

/// The square of `junctionSpeed` [mm²/s²].
double junctionSpeed2(const MotionSegment& before, const MotionSegment& after, double junction_deviation_mm) {
  if (before.direction.isZero() || after.direction.isZero()) return 0.0;
  const double feed2 = squared(std::min(before.feed_mm_s, after.feed_mm_s));
  const double cos_turn = std::clamp(before.direction.dot(after.direction), -1.0, 1.0);
  const double cos_half2 = 0.5 * (1.0 + cos_turn);  // of half the turn
  const double sin_half2 = 0.5 * (1.0 - cos_turn);
  if (sin_half2 < 1e-14) return feed2;
  if (cos_half2 < 1e-14) return 0.0;
  const double acceleration = std::min(before.acceleration_mm_s2, after.acceleration_mm_s2);
  const double half_length = 0.5 * std::min(before.length_mm, after.length_mm);
  // Most corners of curves are run at full feed, which a bound without roots shows: cos <= sqrt(cos).
  const double surely2 = kSurely * feed2;
  if (acceleration * junction_deviation_mm * cos_half2 * (1.0 + cos_half2) >= surely2 * sin_half2 &&
      squared(acceleration * half_length) * cos_half2 >= squared(surely2) * sin_half2)
    return feed2;
  // Circle in the corner: its distance from the corner is r (1 / cos(turn / 2) - 1), it touches at r tan(turn
  // / 2).
  const double cos_half = std::sqrt(cos_half2);
  const double per_sine = 1.0 / std::sqrt(sin_half2);
  const double by_deviation = junction_deviation_mm * cos_half * (1.0 + cos_half) * squared(per_sine);
  const double by_length = half_length * cos_half * per_sine;
  return std::min(feed2, acceleration * std::min(by_deviation, by_length));
}

void requirePositive(double value, const char* what, const char* unit) {
  if (!(value > 0.0 && std::isfinite(value))) refuse(value, what, unit);
}

}  // namespace

double SpeedProfile::distanceAt(double time_s) const {
  const double t = std::clamp(time_s, 0.0, duration_s);
  const double speeding_up_s = (cruise_mm_s - entry_mm_s) / acceleration_mm_s2;
  const double braking_s = (cruise_mm_s - exit_mm_s) / acceleration_mm_s2;
  if (t < speeding_up_s) return t * (entry_mm_s + 0.5 * acceleration_mm_s2 * t);
  const double left_s = duration_s - t;
  if (left_s < braking_s) return length_mm - left_s * (exit_mm_s + 0.5 * acceleration_mm_s2 * left_s);
  const double speeding_up_mm = 0.5 * speeding_up_s * (entry_mm_s + cruise_mm_s);
  return std::min(length_mm, speeding_up_mm + cruise_mm_s * (t - speeding_up_s));
}

double SpeedProfile::speedAt(double time_s) const {
  const double t = std::clamp(time_s, 0.0, duration_s);
  return std::min(
      {cruise_mm_s, entry_mm_s + acceleration_mm_s2 * t, exit_mm_s + acceleration_mm_s2 * (duration_s - t)});
}

SpeedProfile speedProfile(const MotionSegment& segment, double entry_mm_s, double exit_mm_s) {
  const double a = segment.acceleration_mm_s2;
  const double peak2 = 0.5 * (gain2(segment) + squared(entry_mm_s) + squared(exit_mm_s));
  SpeedProfile profile;
  profile.length_mm = segment.length_mm;
  profile.acceleration_mm_s2 = a;
  profile.entry_mm_s = entry_mm_s;
  profile.exit_mm_s = exit_mm_s;
  const bool has_peak = peak2 < squared(segment.feed_mm_s);
  // Rounding must not put the peak below either end.
  profile.cruise_mm_s = std::max({has_peak ? std::sqrt(peak2) : segment.feed_mm_s, entry_mm_s, exit_mm_s});
  profile.duration_s = (2.0 * profile.cruise_mm_s - entry_mm_s - exit_mm_s) / a;
  if (has_peak) return profile;
  const double ramps_mm =
      (2.0 * squared(profile.cruise_mm_s) - squared(entry_mm_s) - squared(exit_mm_s)) / (2.0 * a);
  profile.duration_s += std::max(0.0, segment.length_mm - ramps_mm) / profile.cruise_mm_s;
  return profile;
}

double junctionSpeed(const MotionSegment& before, const MotionSegment& after, double junction_deviation_mm) {
  return std::sqrt(junctionSpeed2(before, after, junction_deviation_mm));
}

void MotionPlanner::add(const MotionSegment& segment) {
  requirePositive(segment.length_mm, "length", "mm");
  requirePositive(segment.feed_mm_s, "feed", "mm/s");
  requirePositive(segment.acceleration_mm_s2, "acceleration", "mm/s2");
  Waiting added{segment};
  if (!waiting_.empty())
    added.entry_limit2 = junctionSpeed2(waiting_.back().segment, segment, junction_deviation_mm_);
  waiting_.push_back(added);
  if (waiting_.size() < look_at_) return;
  settle(Ending::Open);
  look_at_ = std::max(kFirstLook, 2 * waiting_.size());
}

void MotionPlanner::finish() {
  settle(Ending::AtRest);
  look_at_ = kFirstLook;
}

std::optional<SpeedProfile> MotionPlanner::next() {
  if (ready_.empty()) return std::nullopt;
  const SpeedProfile profile = ready_.front();
  ready_.pop_front();
  return profile;
}

/// Braking speeds are only known to be at least those from which the nozzle can stop after the last segment.
/// Where speeding up to a junction does not reach that speed, more segments cannot change the junction, nor
/// any before it.
std::size_t MotionPlanner::settledCount(Ending ending) const {
  if (ending == Ending::AtRest) return waiting_.size();
  std::size_t settled = 0;
  double entry2 = entry2_;
  for (std::size_t i = 1; i < waiting_.size(); ++i) {
    const double reached2 = std::min(waiting_[i].entry_limit2, entry2 + gain2(waiting_[i - 1].segment));
    if (reached2 <= waiting_[i].entry_brake2) settled = i;
    entry2 = std::min(reached2, waiting_[i].entry_brake2);
  }
  return settled;
}

void MotionPlanner::settle(Ending ending) {
  double brake2 = 0.0;
  for (std::size_t i = waiting_.size(); i-- > 0;) {
    brake2 = std::min(waiting_[i].entry_limit2, brake2 + gain2(waiting_[i].segment));
    waiting_[i].entry_brake2 = brake2;
  }
  const std::size_t settled = settledCount(ending);
  double entry_mm_s = std::sqrt(entry2_);
  for (std::size_t i = 0; i < settled; ++i) {
    const MotionSegment& segment = waiting_[i].segment;
    const double exit_limit2 = i + 1 < waiting_.size() ? waiting_[i + 1].entry_brake2 : 0.0;
    const double exit2 = std::min(exit_limit2, entry2_ + gain2(segment));
    const double exit_mm_s = std::sqrt(exit2);
    ready_.push_back(speedProfile(segment, entry_mm_s, exit_mm_s));
    entry2_ = exit2;
    entry_mm_s = exit_mm_s;
  }
  waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(settled));
}

}  // namespace lamina
