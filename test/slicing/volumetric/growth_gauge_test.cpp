// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "slicing/volumetric/growth_gauge.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/angle.hpp"

namespace lamina {
namespace {

GrowthGauge gaugeOf(double overhang_deg, double max_thickness = 2.0, double max_tilt_deg = 80.0) {
  return GrowthGauge({toRadians(overhang_deg), max_thickness, toRadians(max_tilt_deg)});
}

Point3 leaning(double lean_deg, double length = 1.0) {
  return length * Point3(std::sin(toRadians(lean_deg)), 0.0, std::cos(toRadians(lean_deg)));
}

double tiltDeg(const Point3& direction) {
  return toDegrees(std::atan2(direction.head<2>().norm(), direction.z()));
}

TEST(GrowthGauge, TakesTheRiseOfWaysUpToTheOverhang) {
  const GrowthGauge gauge = gaugeOf(30.0);
  EXPECT_EQ(gauge.cost(Point3::Zero()), 0.0);
  EXPECT_EQ(gauge.cost(Point3(0.1, 0.2, 3.0)), 3.0);
  EXPECT_EQ(gauge.gradient(leaning(29.0)), Point3::UnitZ());
  EXPECT_NEAR(gauge.cost(leaning(30.0)), std::cos(toRadians(30.0)), 1e-12);
}

// Of a level underside, by the overhang: tilt 90 - overhang, and thickness exp((90 - overhang) tan overhang).
TEST(GrowthGauge, TiltsAndThickensOverALevelUnderside) {
  const double expected[][2] = {{0.0, 1.0}, {10.0, 1.279}, {20.0, 1.560}, {25.0, 1.697}, {30.0, 1.831}};
  for (const auto& [overhang, thickness] : expected) {
    const Point3 gradient = gaugeOf(overhang, 3.0, 90.0).gradient(leaning(90.0));
    EXPECT_NEAR(tiltDeg(gradient), 90.0 - overhang, 1e-9);
    EXPECT_NEAR(1.0 / gradient.norm(), thickness, 1e-3);
  }
}

TEST(GrowthGauge, KeepsTheNormalWhereLayersAreAsThickAsTheyMayBe) {
  const GrowthGauge gauge = gaugeOf(30.0, 1.5);
  const double thickest = 30.0 + toDegrees(std::log(1.5) / std::tan(toRadians(30.0)));
  EXPECT_NEAR(1.0 / gauge.gradient(leaning(thickest + 10.0)).norm(), 1.5, 1e-12);
  EXPECT_NEAR(tiltDeg(gauge.gradient(leaning(thickest + 10.0))), thickest - 30.0, 1e-9);
  EXPECT_NEAR(gauge.cost(leaning(thickest - 1e-9)), gauge.cost(leaning(thickest + 1e-9)), 1e-9);
}

TEST(GrowthGauge, AllowsNoWayBeyondTheTilt) {
  EXPECT_TRUE(std::isfinite(gaugeOf(30.0).cost(leaning(109.9))));
  EXPECT_TRUE(std::isinf(gaugeOf(30.0).cost(leaning(110.1))));
}

TEST(GrowthGauge, OverhangIsLoweredUntilLayersAreThinEnough) {
  EXPECT_EQ(overhangWithin(toRadians(30.0), 2.0), toRadians(30.0));
  const double lowered = overhangWithin(toRadians(45.0), 2.0);
  EXPECT_NEAR(std::exp((0.5 * M_PI - lowered) * std::tan(lowered)), 2.0, 1e-9);
}

// Layers of one thickness tilt as their paths lean.
TEST(GrowthGauge, OfOneThicknessIsTheLengthOfThePath) {
  const double overhang = overhangWithin(toRadians(25.0), 1.0);
  EXPECT_EQ(overhang, 0.0);
  const GrowthGauge gauge({overhang, 1.0, toRadians(80.0)});
  EXPECT_NEAR(gauge.cost({3.0, 0.0, 4.0}), 5.0, 1e-12);
  EXPECT_NEAR(gauge.cost({4.0, 3.0, 1.0}), std::sqrt(26.0), 1e-12);
  EXPECT_TRUE(std::isinf(gauge.cost({1.0, 0.0, 0.0}))) << "beyond the greatest tilt";
}

struct RandomGauge {
  double overhang_deg;
  GrowthGauge gauge;
};

RandomGauge anyGauge() {
  const double overhang = 0.01 * *rc::gen::inRange(0, 4000);
  return {overhang, gaugeOf(overhang, 0.01 * *rc::gen::inRange(150, 300), 90.0)};
}

Point3 anyWayUp() {
  const double lean = 0.01 * *rc::gen::inRange(0, 9000);
  const double heading = toRadians(0.01 * *rc::gen::inRange(0, 36000));
  const double length = 0.01 * *rc::gen::inRange(1, 5000);
  const Point3 way = leaning(lean, length);
  return {way.x() * std::cos(heading), way.x() * std::sin(heading), way.z()};
}

TEST(GrowthGauge, GoingRoundIsNeverShorter) {
  EXPECT_TRUE(rc::check([] {
    const GrowthGauge gauge = anyGauge().gauge;
    const Point3 a = anyWayUp();
    const Point3 b = anyWayUp();
    RC_ASSERT(gauge.cost(a + b) <= gauge.cost(a) + gauge.cost(b) + 1e-9);
  }));
}

TEST(GrowthGauge, GradientIsThatOfTheCost) {
  EXPECT_TRUE(rc::check([] {
    const GrowthGauge gauge = anyGauge().gauge;
    const Point3 way = anyWayUp();
    const Point3 gradient = gauge.gradient(way);
    RC_ASSERT(std::abs(gradient.dot(way) - gauge.cost(way)) < 1e-9 * way.norm());
    // Convex: nowhere below its tangent.
    const Point3 other = anyWayUp();
    RC_ASSERT(gauge.cost(way + other) >= gauge.cost(way) + gradient.dot(other) - 1e-9);
  }));
}

// At a surface the way comes from inside, or along it: its normal cannot lag behind by more than the
// overhang.
TEST(GrowthGauge, NoSurfaceOverhangsByMoreThanIsUsed) {
  EXPECT_TRUE(rc::check([] {
    const double overhang = 0.01 * *rc::gen::inRange(0, 3000);
    const GrowthGauge gauge = gaugeOf(overhang, 2.0);
    const Point3 way = anyWayUp();
    const Point3 side = way.cross(anyWayUp());
    if (side.norm() < 1e-6) return;
    const Point3 normal = side.cross(way).normalized();
    const Point3 growth = gauge.gradient(way).normalized();
    RC_ASSERT(std::abs(normal.dot(growth)) <= std::sin(toRadians(overhang)) + 1e-9);
    const double thickness = 1.0 / gauge.gradient(way).norm();
    RC_ASSERT(thickness >= 1.0 - 1e-12);
    RC_ASSERT(thickness <= 2.0 + 1e-12);
  }));
}

}  // namespace
}  // namespace lamina
