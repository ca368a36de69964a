// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/trajectory/rest_to_rest.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/error.hpp"
#include "support/random_toolpath.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

constexpr double kSpeed = 50.0;           // mm/s
constexpr double kAcceleration = 1000.0;  // mm/s²

MotionLimits limitsOfTheSource() {
  MotionLimits limits;
  limits.acceleration_mm_s2 = limits.travel_acceleration_mm_s2 = kAcceleration;
  return limits;
}

Toolpath lineThrough(const std::vector<Point3>& points) {
  Path path = test::straightPath(points.front(), points.back());
  path.points = points;
  path.feed_mm_s = kSpeed;
  return {"line", {{0.2, 0.2, {path}}}};
}

TEST(RestToRest, TakesTheTimesOfTheSource) {
  EXPECT_NEAR(restToRestTime(1.0, kSpeed, kAcceleration), 0.063246, 1e-6);
  EXPECT_NEAR(restToRestTime(2.5, kSpeed, kAcceleration), 0.1, 1e-12);
  EXPECT_NEAR(restToRestTime(10.0, kSpeed, kAcceleration), 0.25, 1e-12);
  const Toolpath two = lineThrough({{0, 0, 0}, {10, 0, 0}, {20, 0, 0}});
  EXPECT_NEAR(restToRestTime(two, limitsOfTheSource()).total_s, 0.5, 1e-12);
}

TEST(RestToRest, DropsMotionsWithoutLength) {
  EXPECT_EQ(restToRestTime(0.0, kSpeed, kAcceleration), 0.0);
  const Toolpath one = lineThrough({{0, 0, 0}, {0, 0, 0}, {10, 0, 0}});
  EXPECT_NEAR(restToRestTime(one, limitsOfTheSource()).total_s, 0.25, 1e-12);
}

TEST(RestToRest, RefusesWhatHasNoTime) {
  EXPECT_THROW(restToRestTime(-1.0, kSpeed, kAcceleration), InvalidInput);
  EXPECT_THROW(restToRestTime(1.0, 0.0, kAcceleration), InvalidInput);
  EXPECT_THROW(restToRestTime(1.0, kSpeed, 0.0), InvalidInput);
  EXPECT_THROW(RestToRestPlayer(Toolpath{}, limitsOfTheSource()), InvalidInput);
  const Toolpath line = lineThrough({{0, 0, 0}, {10, 0, 0}});
  EXPECT_THROW(RestToRestPlayer(line, limitsOfTheSource()).sampled(0.0), InvalidInput);
}

TEST(RestToRest, RampsUpCruisesAndRampsDown) {
  const Toolpath line = lineThrough({{0, 0, 0}, {10, 0, 0}});
  const RestToRestPlayer player(line, limitsOfTheSource());
  EXPECT_NEAR(player.at(0.02).velocity.x(), 20.0, 1e-9);
  EXPECT_NEAR(player.at(0.02).position.x(), 0.2, 1e-9);
  EXPECT_NEAR(player.at(0.02).acceleration.x(), kAcceleration, 1e-9);
  EXPECT_NEAR(player.at(0.125).velocity.x(), kSpeed, 1e-9);
  EXPECT_NEAR(player.at(0.125).position.x(), 5.0, 1e-9);
  EXPECT_NEAR(player.at(0.125).acceleration.x(), 0.0, 1e-9);
  EXPECT_NEAR(player.at(0.23).velocity.x(), 20.0, 1e-9);
  EXPECT_NEAR(player.at(0.23).acceleration.x(), -kAcceleration, 1e-9);
  EXPECT_NEAR(player.at(9.0).position.x(), 10.0, 1e-12);
  EXPECT_EQ(player.at(9.0).velocity, Point3::Zero());
  EXPECT_EQ(player.at(-1.0).position, Point3::Zero());
}

TEST(RestToRest, SumsTheTimesOfLayers) {
  const ToolpathTime time = restToRestTime(test::twoLayers(), limitsOfTheSource());
  const double line = restToRestTime(10.0, 30.0, kAcceleration);
  const double rise = restToRestTime(0.2, 30.0, kAcceleration);
  ASSERT_EQ(time.layer_start_s.size(), 2U);
  EXPECT_NEAR(time.layer_start_s[1], 4 * line + rise, 1e-12);
  EXPECT_NEAR(time.total_s, 5 * line + rise, 1e-12);
}

TEST(RestToRest, SamplesAddUpByTrapezoids) {
  EXPECT_TRUE(rc::check("velocities, summed by trapezoids, give positions", [] {
    const Toolpath toolpath = test::randomToolpath(*rc::gen::arbitrary<std::uint64_t>());
    const RestToRestPlayer player(toolpath, limitsOfTheSource());
    RC_ASSERT(std::abs(player.duration() - restToRestTime(toolpath, limitsOfTheSource()).total_s) < 1e-9);
    const double step_s = 1e-3;
    const auto samples = player.sampled(step_s);
    Point3 position = samples.front().position;
    for (std::size_t i = 1; i < samples.size(); ++i) {
      const double dt = samples[i].time_s - samples[i - 1].time_s;
      position += 0.5 * dt * (samples[i].velocity + samples[i - 1].velocity);
      // A kink of the velocity within a step costs a (dt / 2)² / 2 or less, two of them at a waypoint.
      RC_ASSERT((position - samples[i].position).norm() < 1.5 * kAcceleration * dt * dt + 1e-9);
      position = samples[i].position;
    }
    RC_ASSERT((samples.back().position - toolpath.layers.back().paths.back().lastPoint()).norm() < 1e-9);
  }));
}

}  // namespace
}  // namespace lamina
