// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/slicing/volumetric/head_room.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "lamina/base/angle.hpp"
#include "slicing/volumetric/head_lean.hpp"

namespace lamina {
namespace {

/// A wall that fills all of x > 10 mm, deposited first.
class WallAtTen final : public HeadRoom::Growth {
 public:
  double at(const Point3& place) const override {
    return place.x() > 10.0 ? 1.0 : std::numeric_limits<double>::infinity();
  }
};

/// A nozzle 20 mm long, and above it a head 30 mm in radius.
HeadRoom roomAt(double bed_mm) {
  return {std::make_shared<const WallAtTen>(), {{0.0, 20.0, 2.0}, {20.0, 80.0, 30.0}}, bed_mm};
}

Point3 tilted(double degrees) { return {std::sin(toRadians(degrees)), 0.0, std::cos(toRadians(degrees))}; }

TEST(HeadRoom, IsClearBesideAWallAsFarAsTheHeadIsWide) {
  const HeadRoom room = roomAt(-100.0);
  EXPECT_TRUE(room.isClear({-21.0, 0.0, 0.0}, Point3::UnitZ(), 2.0));
  EXPECT_FALSE(room.isClear({-19.0, 0.0, 0.0}, Point3::UnitZ(), 2.0));
  // Not deposited yet.
  EXPECT_TRUE(room.isClear({-19.0, 0.0, 0.0}, Point3::UnitZ(), 0.5));
}

// The rim of the head is at 20 cos t - 30 sin t above the tip: level with it at 33.7 deg.
TEST(HeadRoom, IsClearOfTheBedAsFarAsTheHeadMayTilt) {
  const HeadRoom room = roomAt(0.0);
  EXPECT_TRUE(room.isClear({-200.0, 0.0, 0.0}, tilted(-33.0), 2.0));
  EXPECT_FALSE(room.isClear({-200.0, 0.0, 0.0}, tilted(-35.0), 2.0));
  EXPECT_TRUE(room.isClear({-200.0, 0.0, 20.0}, tilted(-60.0), 2.0));
}

TEST(HeadRoom, OfNoHeadIsClearEverywhere) {
  const HeadRoom room(std::make_shared<const WallAtTen>(), {}, 0.0);
  EXPECT_TRUE(room.isClear({50.0, 0.0, 1.0}, Point3::UnitZ(), 2.0));
}

TEST(HeadLean, TurnsTowardsUpAndNoFarther) {
  EXPECT_NEAR((turnedUp(tilted(50.0), toRadians(20.0)) - tilted(30.0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((turnedUp(tilted(10.0), toRadians(20.0)) - Point3::UnitZ()).norm(), 0.0, 1e-12);
  EXPECT_EQ(turnedUp(tilted(10.0), 0.0), tilted(10.0));
}

}  // namespace
}  // namespace lamina
