// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/travel/travel.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TravelSettings travelSettings() { return {100.0, 0.5, 2.0}; }

TEST(Travel, ToTheSamePointIsNone) { EXPECT_FALSE(makeTravel({1, 2, 3}, {1, 2, 3}, travelSettings())); }

TEST(Travel, WithinTheThresholdIsStraight) {
  const auto travel = makeTravel({0, 0, 1}, {2, 0, 1}, travelSettings());
  ASSERT_TRUE(travel);
  EXPECT_EQ(travel->points, (std::vector<Point3>{{0, 0, 1}, {2, 0, 1}}));
  EXPECT_FALSE(travel->process.is_retracted);
  EXPECT_EQ(travel->role, PathRole::Travel);
  EXPECT_EQ(travel->feed_mm_s.at(0), 100.0);
  EXPECT_EQ(travel->bead.at(0).width_mm, 0.0);
}

TEST(Travel, BeyondTheThresholdGoesUpOverAndDownRetracted) {
  const auto travel = makeTravel({0, 0, 1}, {5, 0, 1}, travelSettings());
  ASSERT_TRUE(travel);
  EXPECT_EQ(travel->points, (std::vector<Point3>{{0, 0, 1}, {0, 0, 1.5}, {5, 0, 1.5}, {5, 0, 1}}));
  EXPECT_TRUE(travel->process.is_retracted);
}

TEST(Travel, OverInfillIsStraightUpToTheLongestWayInside) {
  const auto travel = makeTravel({0, 0, 1}, {30, 0, 1}, travelSettings(), TravelOver::Infill);
  ASSERT_TRUE(travel);
  EXPECT_EQ(travel->points.size(), 2U);
  EXPECT_FALSE(travel->process.is_retracted);
}

TEST(Travel, WithoutHopIsStraightThoughRetracted) {
  TravelSettings flat = travelSettings();
  flat.hop_mm = 0.0;
  const auto travel = makeTravel({0, 0, 1}, {5, 0, 1}, flat);
  EXPECT_EQ(travel->points.size(), 2U);
  EXPECT_TRUE(travel->process.is_retracted);
}

TEST(Travel, ToTheNextLayerRisesBeforeItMovesOver) {
  const auto near = makeTravel({0, 0, 1}, {1, 0, 1.2}, travelSettings());
  EXPECT_EQ(near->points, (std::vector<Point3>{{0, 0, 1}, {0, 0, 1.2}, {1, 0, 1.2}}));
  const auto far = makeTravel({0, 0, 1}, {9, 0, 1.2}, travelSettings());
  EXPECT_EQ(far->points, (std::vector<Point3>{{0, 0, 1}, {0, 0, 1.7}, {9, 0, 1.7}, {9, 0, 1.2}}));
  const auto above = makeTravel({0, 0, 1}, {0, 0, 1.2}, travelSettings());
  EXPECT_EQ(above->points, (std::vector<Point3>{{0, 0, 1}, {0, 0, 1.2}}));
}

}  // namespace
}  // namespace lamina
