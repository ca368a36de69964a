// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/bridges/bridge_direction.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/Geometry>

#include <cmath>

#include "lamina/geometry/polygon/offset.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

constexpr double kDegree = M_PI / 180.0;
const BridgeSearch kUsual{1.0, 0.35708, 0.5};

Polygon turned(const Polygon& polygon, double angle_deg) {
  const Eigen::Rotation2D<double> turn(angle_deg * kDegree);
  Polygon result;
  for (const Point2& point : polygon) result.emplace_back(turn * point);
  return result;
}

/// Pillars of 10 x 20 mm, 20 mm apart, and what lies between them within walls.
struct Gap {
  Region piece;
  Regions below;
};

Gap gapAt(double angle_deg) {
  const double half = 10.0 - 0.735619;
  return {{turned(rectangle(-10, -half, 10, half), angle_deg), {}},
          unite({turned(rectangle(-20, -10, -10, 10), angle_deg),
                 turned(rectangle(10, -10, 20, 10), angle_deg)})};
}

/// Between two directions, in [0, 90] deg.
double apart_deg(double a_rad, double b_deg) {
  const double apart = std::abs(std::remainder(a_rad / kDegree - b_deg, 180.0));
  return apart;
}

TEST(BridgeDirection, LeadsFromPillarToPillar) {
  for (const double angle_deg : {0.0, 27.0, 90.0, 153.4}) {
    const Gap gap = gapAt(angle_deg);
    const BridgeDirection found = bridgeDirection(gap.piece, gap.below, kUsual);
    EXPECT_LT(apart_deg(found.angle_rad, angle_deg), 0.5) << angle_deg;
    EXPECT_NEAR(found.held, 1.0, 1e-9) << angle_deg;
    EXPECT_NEAR(found.span_mm, 20.0, 1e-3) << angle_deg;
  }
}

TEST(BridgeDirection, HoldsNothingAcrossThePillars) {
  const Gap gap = gapAt(0.0);
  EXPECT_EQ(bridgeAlong(0.5 * M_PI, gap.piece, gap.below, kUsual).held, 0.0);
  // At 45 deg lines of 18.53 mm / sin 45 leave by the free sides, but those that go from corner to corner.
  EXPECT_LT(bridgeAlong(0.25 * M_PI, gap.piece, gap.below, kUsual).held, 0.1);
}

TEST(BridgeDirection, CrossesTheShorterArm) {
  // Two L-shaped pillars hold an opening of 30 x 12 mm on all sides but for gaps in two corners.
  const Region opening{rectangle(0, 0, 30, 12), {}};
  const Regions below = unite({rectangle(-5, -5, 0, 11.8), rectangle(-5, -5, 29.8, 0),
                               rectangle(30, 0.2, 35, 17), rectangle(0.2, 12, 35, 17)});
  const BridgeDirection found = bridgeDirection(opening, below, kUsual);
  EXPECT_LT(apart_deg(found.angle_rad, 90.0), 0.5);
  EXPECT_NEAR(found.span_mm, 12.0, 1e-3);
  EXPECT_GT(found.held, 0.95);
}

TEST(BridgeDirection, JoinsTheArmsOfOnePillar) {
  // An L holds two sides of a square: threads from arm to arm, half of the square at most.
  const Region square{rectangle(0, 0, 20, 20), {}};
  const Regions below = unite({rectangle(-5, -5, 0, 20), rectangle(-5, -5, 20, 0)});
  const BridgeDirection found = bridgeDirection(square, below, kUsual);
  EXPECT_LT(apart_deg(found.angle_rad, 135.0), 3.0);
  EXPECT_NEAR(found.held, 0.5, 0.03);
}

TEST(BridgeDirection, IsAnyOverARoundHole) {
  const Polygon hole = test::circle({3, 4}, 5.0, 180);
  const Regions below = unite({rectangle(-20, -20, 20, 20), test::reversed(hole)});
  const BridgeDirection found = bridgeDirection({hole, {}}, below, kUsual);
  EXPECT_NEAR(found.held, 1.0, 1e-9);
  EXPECT_NEAR(found.span_mm, 10.0, 0.02);
  for (const double angle_deg : {0.0, 33.0, 122.0})
    EXPECT_NEAR(bridgeAlong(angle_deg * kDegree, {hole, {}}, below, kUsual).held, 1.0, 1e-9);
}

TEST(BridgeDirection, HoldsNothingOnOneSideOnly) {
  const Region plate{rectangle(0, 0, 20, 10), {}};
  const Regions below = unite({rectangle(-10, 0, 0, 10)});
  EXPECT_LT(bridgeDirection(plate, below, kUsual).held, 0.5);
  EXPECT_EQ(bridgeAlong(0.0, plate, below, kUsual).held, 0.0);
}

TEST(BridgeDirection, HoldsNothingOverNothing) {
  const Region plate{rectangle(0, 0, 20, 10), {}};
  for (const Regions& below : {Regions{}, unite({rectangle(100, 0, 110, 10)})}) {
    const BridgeDirection found = bridgeDirection(plate, below, kUsual);
    EXPECT_EQ(found.held, 0.0);
    EXPECT_EQ(found.span_mm, 0.0);
  }
  EXPECT_EQ(bridgeDirection({}, {}, kUsual).held, 0.0);
}

TEST(BridgeDirection, SpansTheShortWayOfANarrowPlank) {
  // 1 mm wide, held at its ends alone: a direction 2 deg off would leave it.
  const double length = 30.0;
  for (const double angle_deg : {12.3, 71.9}) {
    const Region plank{turned(rectangle(0, -0.5, length, 0.5), angle_deg), {}};
    const Regions below = unite({turned(rectangle(-5, -5, 0, 5), angle_deg),
                                 turned(rectangle(length, -5, length + 5, 5), angle_deg)});
    const BridgeDirection found = bridgeDirection(plank, below, kUsual);
    EXPECT_LT(apart_deg(found.angle_rad, angle_deg), 0.2) << angle_deg;
    EXPECT_NEAR(found.span_mm, length, 1e-2) << angle_deg;
  }
}

TEST(BridgeDirection, CountsTheWayUnderWallsToo) {
  // Between walls only 0.8 mm of a gap of 1.5 mm are left: a slanted thread leaves the piece sooner, not the
  // gap.
  const Region piece{rectangle(0.75, 0, 1.55, 1.5), {}};
  const Regions below = unite({rectangle(0, -4, 2.3, 0), rectangle(0, 1.5, 2.3, 5.5)});
  const BridgeDirection found = bridgeDirection(piece, below, kUsual);
  EXPECT_LT(apart_deg(found.angle_rad, 90.0), 0.5);
  EXPECT_NEAR(found.span_mm, 1.5, 1e-3);
}

TEST(BridgeDirection, TurnsWithThePart) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    const double angle_deg = random.uniform(-180.0, 180.0);
    const double span = random.uniform(4.0, 40.0);
    const double width = random.uniform(2.0, 30.0);
    const Region piece{turned(rectangle(0, 0, span, width), angle_deg), {}};
    const Regions below = unite({turned(rectangle(-8, -1, 0, width + 1), angle_deg),
                                 turned(rectangle(span, -1, span + 8, width + 1), angle_deg)});
    const BridgeDirection found = bridgeDirection(piece, below, kUsual);
    RC_ASSERT(apart_deg(found.angle_rad, angle_deg) < 0.5);
    RC_ASSERT(found.held > 0.999);
    RC_ASSERT(std::abs(found.span_mm - span) < 1e-2);
  }));
}

}  // namespace
}  // namespace lamina
