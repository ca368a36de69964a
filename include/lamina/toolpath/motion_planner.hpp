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
  double length_mm = 0.0;             ///< positive; for a motion in place, the length of the filament
  double feed_mm_s = 0.0;             ///< positive; not reached if the length is too short
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

  /// Distance travelled after `time_s`, which is clamped to [0, duration_s] [mm].
  double distanceAt(double time_s) const;
  double speedAt(double time_s) const;
};

/// The fastest speed profile along a segment between given entry and exit speeds, which the segment's length
/// must allow.
SpeedProfile speedProfile(const MotionSegment& segment, double entry_mm_s, double exit_mm_s);

/// Greatest speed at the corner between two segments [mm/s].
///
/// It is the speed at which the nozzle could follow an arc that rounds the corner, with the lesser of the two
/// accelerations as centripetal acceleration. The arc passes the corner at a distance of at most
/// `junction_deviation_mm`, and touches each segment at most half its length from the corner, so that a
/// finely divided curve gets the speed that its curvature allows. Segments in one direction give the lesser
/// feed; a reversal or a motion in place gives 0.
double junctionSpeed(const MotionSegment& before, const MotionSegment& after, double junction_deviation_mm);

/// Plans the speeds of straight motions that are added one by one: trapezoidal profiles with unlimited
/// look-ahead.
///
/// Segments are added by `add`; `next` returns their profiles in the same order, each as soon as no later
/// segment can change it. A profile is final once the later segments are as long as the braking distance. It
/// is returned a few segments later, since this is tested at intervals to keep the time linear. `finish`
/// brings the nozzle to rest after the last segment; segments added afterwards start from rest.
class MotionPlanner {
 public:
  explicit MotionPlanner(double junction_deviation_mm) : junction_deviation_mm_(junction_deviation_mm) {}

  /// @throws InvalidInput if length, feed or acceleration is not positive and finite
  void add(const MotionSegment& segment);
  void finish();
  /// The profile of the next segment; nothing as long as it can still change, or if there is none.
  std::optional<SpeedProfile> next();

  /// Number of segments whose profile can still change.
  std::size_t waiting() const { return waiting_.size(); }

 private:
  enum class Ending { Open, AtRest };
  struct Waiting {
    MotionSegment segment;
    double entry_limit2 = 0.0;  ///< squared speeds [mm²/s²]
    double entry_brake2 = 0.0;  ///< greatest one from which the nozzle can still stop after the last segment
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
