// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A straight motion to be timed.
struct MotionSegment {
  Point3 direction = Point3::Zero();  ///< of unit length; zero for a motion in place, such as a retraction
  double length_mm = 0.0;             ///< positive; of filament if in place
  double feed_mm_s = 0.0;             ///< positive; reached only if the length allows
  double acceleration_mm_s2 = 0.0;    ///< positive
};

/// Speed along one segment: constant acceleration, constant speed, constant deceleration, any of which may be
/// absent.
struct SpeedProfile {
  double length_mm = 0.0;
  double acceleration_mm_s2 = 0.0;
  double entry_mm_s = 0.0;
  double cruise_mm_s = 0.0;
  double exit_mm_s = 0.0;
  double duration_s = 0.0;

  /// Distance gone after `time_s`, which is clamped to [0, duration] [mm].
  double distanceAt(double time_s) const;
  double speedAt(double time_s) const;
};

/// The fastest speed profile along a segment between given entry and exit speeds, which its length must
/// allow.
SpeedProfile speedProfile(const MotionSegment& segment, double entry_mm_s, double exit_mm_s);

/// Greatest speed at the corner between two segments [mm/s].
///
/// The corner is thought of as rounded by a circle, run at the lesser of the two accelerations. The circle
/// leaves the corner by `junction_deviation_mm` at most and touches both segments no further out than half
/// their length, so that a finely divided curve is run at the speed its curvature allows. Straight on gives
/// the lesser feed, a reversal or a motion in place 0.
double junctionSpeed(const MotionSegment& before, const MotionSegment& after, double junction_deviation_mm);

/// Times straight motions that come one by one: trapezoidal speeds with unlimited look-ahead.
///
/// Segments go in by `add`; profiles come out of `next` in the same order, as soon as no later segment can
/// change them, which is at the latest when the segments waiting are as long as the braking distance (and a
/// few more: it looks only now and then, which keeps the work linear). `finish` lets the nozzle come to rest
/// after the last segment; adding after that starts from rest.
class MotionPlanner {
 public:
  explicit MotionPlanner(double junction_deviation_mm) : junction_deviation_mm_(junction_deviation_mm) {}

  /// @throws InvalidInput if length, feed or acceleration is not positive and finite
  void add(const MotionSegment& segment);
  void finish();
  std::optional<SpeedProfile> next();

  /// Segments whose speed later ones can still change.
  std::size_t waiting() const { return waiting_.size(); }

 private:
  enum class Ending { Open, AtRest };
  struct Waiting {
    MotionSegment segment;
    double entry_limit2 = 0.0;  ///< squared speeds [mm²/s²]
    double entry_brake2 = 0.0;  ///< from which the nozzle can still stop after the last segment
  };

  void settle(Ending ending);
  std::size_t settledCount(Ending ending) const;

  double junction_deviation_mm_;
  double entry2_ = 0.0;  ///< of the first waiting segment
  std::size_t look_at_ = 32;
  std::vector<Waiting> waiting_;
  std::deque<SpeedProfile> ready_;
};

}  // namespace lamina
