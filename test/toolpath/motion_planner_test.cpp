// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/toolpath/motion_planner.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"

namespace lamina {
namespace {

constexpr double kDeviation = 0.02;

MotionSegment along(const Point3& direction, double length_mm, double feed_mm_s,
                    double acceleration = 1000.0) {
  return {direction.normalized(), length_mm, feed_mm_s, acceleration};
}

std::vector<SpeedProfile> planned(const std::vector<MotionSegment>& segments) {
  MotionPlanner planner(kDeviation);
  std::vector<SpeedProfile> profiles;
  for (const MotionSegment& segment : segments) {
    planner.add(segment);
    while (const auto profile = planner.next()) profiles.push_back(*profile);
  }
  planner.finish();
  while (const auto profile = planner.next()) profiles.push_back(*profile);
  return profiles;
}

double totalTime(const std::vector<SpeedProfile>& profiles) {
  double sum = 0.0;
  for (const SpeedProfile& profile : profiles) sum += profile.duration_s;
  return sum;
}

TEST(MotionPlanner, LongMotionFromRestToRestTakesLengthOverFeedPlusOneRamp) {
  // Ramps of v / a = 0.1 s each cover half the way cruising would: t = L / v + v / a.
  const auto profiles = planned({along(Point3::UnitX(), 100.0, 100.0)});
  EXPECT_NEAR(totalTime(profiles), 1.1, 1e-12);
  EXPECT_DOUBLE_EQ(profiles[0].cruise_mm_s, 100.0);
}

TEST(MotionPlanner, ShortMotionFromRestToRestIsATriangle) {
  // Half of 4 mm speeding up: t = 2 sqrt(L / a), peak sqrt(L a).
  const auto profiles = planned({along(Point3::UnitX(), 4.0, 100.0)});
  EXPECT_NEAR(totalTime(profiles), 2.0 * std::sqrt(4.0 / 1000.0), 1e-12);
  EXPECT_NEAR(profiles[0].cruise_mm_s, std::sqrt(4000.0), 1e-9);
}

TEST(MotionPlanner, SplittingAStraightMotionChangesNothing) {
  const std::vector<MotionSegment> pieces(1000, along({1.0, 2.0, 3.0}, 0.1, 100.0));
  EXPECT_NEAR(totalTime(planned(pieces)), 1.1, 1e-9);
}

TEST(MotionPlanner, ReversalComesToRest) {
  const auto profiles =
      planned({along(Point3::UnitX(), 100.0, 100.0), along(-Point3::UnitX(), 100.0, 100.0)});
  EXPECT_NEAR(totalTime(profiles), 2.2, 1e-12);
  EXPECT_DOUBLE_EQ(profiles[1].entry_mm_s, 0.0);
}

TEST(MotionPlanner, MotionInPlaceStandsBetweenRests) {
  MotionSegment retraction{Point3::Zero(), 1.0, 40.0, 1000.0};
  const auto profiles =
      planned({along(Point3::UnitX(), 100.0, 100.0), retraction, along(Point3::UnitX(), 100.0, 100.0)});
  EXPECT_DOUBLE_EQ(profiles[1].entry_mm_s, 0.0);
  EXPECT_DOUBLE_EQ(profiles[2].entry_mm_s, 0.0);
}

TEST(MotionPlanner, RightAngleIsRunAtTheSpeedOfItsDeviation) {
  // Turn of 90 degrees: r = d cos 45 / (1 - cos 45), v = sqrt(a r).
  const double radius = kDeviation * M_SQRT1_2 / (1.0 - M_SQRT1_2);
  const auto profiles = planned({along(Point3::UnitX(), 100.0, 100.0), along(Point3::UnitY(), 100.0, 100.0)});
  EXPECT_NEAR(profiles[0].exit_mm_s, std::sqrt(1000.0 * radius), 1e-9);
  EXPECT_DOUBLE_EQ(profiles[0].exit_mm_s, profiles[1].entry_mm_s);
}

TEST(MotionPlanner, FineCircleIsRunAtTheSpeedOfItsRadius) {
  // Centripetal acceleration v² / r = a: 5 mm radius and 1000 mm/s² give 70.71 mm/s, however finely it is
  // divided.
  for (const int count : {2000, 20000}) {
    std::vector<MotionSegment> circle;
    for (int i = 0; i < count; ++i) {
      const double angle = 2.0 * M_PI * i / count;
      circle.push_back(along({-std::sin(angle), std::cos(angle), 0.0}, 10.0 * std::sin(M_PI / count), 500.0));
    }
    const auto profiles = planned(circle);
    EXPECT_NEAR(profiles[profiles.size() / 2].entry_mm_s, std::sqrt(5.0 * 1000.0), 0.1) << count;
  }
}

TEST(MotionPlanner, StartsFromRestAfterFinish) {
  MotionPlanner planner(kDeviation);
  planner.add(along(Point3::UnitX(), 100.0, 100.0));
  planner.finish();
  ASSERT_TRUE(planner.next());
  planner.add(along(Point3::UnitX(), 100.0, 100.0));
  planner.finish();
  const auto profile = planner.next();
  ASSERT_TRUE(profile);
  EXPECT_DOUBLE_EQ(profile->entry_mm_s, 0.0);
}

TEST(MotionPlanner, HoldsBackNoMoreThanBrakingNeeds) {
  MotionPlanner planner(kDeviation);
  std::size_t most = 0;
  for (int i = 0; i < 100000; ++i) {
    planner.add(along(Point3::UnitX(), 0.1, 100.0));
    most = std::max(most, planner.waiting());
  }
  EXPECT_LE(most, 2 * 51U + 32U);  // 5 mm of braking distance in pieces of 0.1 mm
}

TEST(MotionPlanner, RefusesWhatTakesForever) {
  MotionPlanner planner(kDeviation);
  EXPECT_THROW(planner.add(along(Point3::UnitX(), 1.0, 0.0)), InvalidInput);
  EXPECT_THROW(planner.add(along(Point3::UnitX(), std::nan(""), 10.0)), InvalidInput);
}

std::vector<MotionSegment> randomSegments(std::uint64_t seed) {
  Random random(seed);
  std::vector<MotionSegment> segments(1 + random.below(300));
  for (MotionSegment& segment : segments) {
    const Point3 direction(random.normal(0, 1), random.normal(0, 1), 0.1 * random.normal(0, 1));
    const bool goes_straight_on = &segment != segments.data() && random.below(3) == 0;
    segment = along(goes_straight_on ? (&segment)[-1].direction : direction,
                    std::pow(10.0, random.uniform(-3, 2)), random.uniform(1, 200), random.uniform(100, 5000));
  }
  return segments;
}

TEST(MotionPlanner, NeverExceedsAnyLimit) {
  EXPECT_TRUE(
      rc::check("speeds, junctions and accelerations stay within their limits", [](std::uint64_t seed) {
        const auto segments = randomSegments(seed);
        const auto profiles = planned(segments);
        RC_ASSERT(profiles.size() == segments.size());
        double speed = 0.0;
        for (std::size_t i = 0; i < segments.size(); ++i) {
          const SpeedProfile& profile = profiles[i];
          RC_ASSERT(profile.entry_mm_s == speed);
          RC_ASSERT(profile.cruise_mm_s <= segments[i].feed_mm_s * (1 + 1e-12));
          if (i > 0)
            RC_ASSERT(speed <= junctionSpeed(segments[i - 1], segments[i], kDeviation) * (1 + 1e-12));
          const double change2 = profile.exit_mm_s * profile.exit_mm_s - speed * speed;
          RC_ASSERT(std::abs(change2) <=
                    2 * segments[i].acceleration_mm_s2 * segments[i].length_mm * (1 + 1e-9));
          speed = profile.exit_mm_s;
        }
        RC_ASSERT(speed == 0.0);
      }));
}

TEST(MotionPlanner, GivesTheProfilesOfLookingAtEverythingAtOnce) {
  EXPECT_TRUE(
      rc::check("the incremental plan equals one backward and one forward pass", [](std::uint64_t seed) {
        const auto segments = randomSegments(seed);
        const auto profiles = planned(segments);
        std::vector<double> speed2(segments.size() + 1, 0.0);
        const auto gain = [&](std::size_t i) {
          return 2 * segments[i].acceleration_mm_s2 * segments[i].length_mm;
        };
        for (std::size_t i = segments.size(); i-- > 1;)
          speed2[i] = std::min(std::pow(junctionSpeed(segments[i - 1], segments[i], kDeviation), 2),
                               speed2[i + 1] + gain(i));
        for (std::size_t i = 1; i < segments.size(); ++i)
          speed2[i] = std::min(speed2[i], speed2[i - 1] + gain(i - 1));
        for (std::size_t i = 0; i < segments.size(); ++i)
          RC_ASSERT(std::abs(profiles[i].entry_mm_s - std::sqrt(speed2[i])) < 1e-6);
      }));
}

TEST(SpeedProfile, DistanceAndSpeedAgree) {
  const SpeedProfile profile = speedProfile(along(Point3::UnitX(), 10.0, 50.0), 10.0, 20.0);
  constexpr double kStep = 1e-6;
  for (double t = kStep; t < profile.duration_s - kStep; t += 0.01) {
    const double speed = (profile.distanceAt(t + kStep) - profile.distanceAt(t - kStep)) / (2.0 * kStep);
    EXPECT_NEAR(speed, profile.speedAt(t), 1e-2);
  }
  EXPECT_DOUBLE_EQ(profile.distanceAt(0.0), 0.0);
  EXPECT_DOUBLE_EQ(profile.distanceAt(profile.duration_s), 10.0);
}

}  // namespace
}  // namespace lamina
