// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/travel/space_travel.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "planning/nozzle_frame.hpp"

namespace lamina {
namespace {

TravelSettings settings() { return {100.0, 0.5, 2.0}; }

NozzlePose upright(const Point3& point) { return {point, nozzleDown()}; }

TEST(SpaceTravel, OverLevelLayersIsThatOfThePlane) {
  const std::vector<std::pair<Point3, Point3>> ways = {{{0, 0, 1}, {2, 0, 1}},
                                                       {{0, 0, 1}, {5, 0, 1}},
                                                       {{0, 0, 1}, {1, 0, 1.2}},
                                                       {{0, 0, 1}, {9, 0, 1.2}},
                                                       {{0, 0, 1}, {0, 0, 1.2}}};
  for (const auto& [from, to] : ways) {
    const auto level = makeTravel(from, to, settings());
    const auto space = makeSpaceTravel(upright(from), upright(to), settings(), to.z());
    ASSERT_TRUE(level && space);
    EXPECT_EQ(space->points, level->points);
    EXPECT_EQ(space->process.is_retracted, level->process.is_retracted);
    EXPECT_TRUE(space->orientation.isCommon());
  }
}

TEST(SpaceTravel, ToTheSamePlaceIsNone) {
  EXPECT_FALSE(makeSpaceTravel(upright({1, 2, 3}), upright({1, 2, 3 + 0.5e-6}), settings(), 9.0));
}

TEST(SpaceTravel, FarAwayLeavesAlongTheToolAxisAndClearsTheHighestTip) {
  const NozzlePose from = {{10, 0, 0}, nozzleAgainst(Point3::UnitX())};
  const NozzlePose to = {{-10, 0, 0}, nozzleAgainst(-Point3::UnitX())};
  const auto travel = makeSpaceTravel(from, to, settings(), 12.0);
  ASSERT_TRUE(travel);
  const std::vector<Point3> expected = {{10, 0, 0},       {10.5, 0, 0},  {10.5, 0, 12.5},
                                        {-10.5, 0, 12.5}, {-10.5, 0, 0}, {-10, 0, 0}};
  ASSERT_EQ(travel->points.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR((travel->points[i] - expected[i]).norm(), 0.0, 1e-12) << i;
  EXPECT_TRUE(travel->process.is_retracted);
  // The nozzle turns high above the part.
  EXPECT_EQ(travel->orientation.at(2).coeffs(), from.orientation.coeffs());
  EXPECT_EQ(travel->orientation.at(3).coeffs(), to.orientation.coeffs());
}

TEST(SpaceTravel, NearbyDoesNotCutThroughALayerThatBends) {
  const double radius = 3.0;
  const auto on = [radius](double angle) {
    const Point3 out(std::sin(angle), 0.0, std::cos(angle));
    return NozzlePose{radius * out, nozzleAgainst(out)};
  };
  for (const double angle : {0.1, 0.3, 0.6}) {
    const auto travel = makeSpaceTravel(on(0.0), on(angle), settings(), 12.0);
    ASSERT_TRUE(travel);
    for (std::size_t i = 1; i < travel->points.size(); ++i)
      for (int part = 0; part <= 20; ++part) {
        const double t = part / 20.0;
        const Point3 point = (1.0 - t) * travel->points[i - 1] + t * travel->points[i];
        EXPECT_GE(point.norm(), radius - 1e-9) << angle;
        EXPECT_LE(point.norm(), radius * (1.0 + 0.5 * angle * angle)) << angle;
      }
  }
}

TEST(SpaceTravel, NearbyRisesAlongTheToolAxisToTheLevelOfTheOther) {
  const NozzlePose from = {{10.0, 0, 0}, nozzleAgainst(Point3::UnitX())};
  const NozzlePose to = {{10.2, 1, 0}, nozzleAgainst(Point3::UnitX())};
  const auto travel = makeSpaceTravel(from, to, settings(), 12.0);
  ASSERT_TRUE(travel);
  ASSERT_EQ(travel->points.size(), 3U);
  EXPECT_NEAR((travel->points[1] - Point3(10.2, 0, 0)).norm(), 0.0, 1e-12);
  EXPECT_FALSE(travel->process.is_retracted);
}

}  // namespace
}  // namespace lamina
