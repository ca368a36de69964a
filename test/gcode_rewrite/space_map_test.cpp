// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/gcode_rewrite/space_map.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

constexpr double kRoundTrip = 1e-9;  // mm

void expectNear(const Point3& actual, const Point3& expected, double tolerance) {
  EXPECT_LT((actual - expected).cwiseAbs().maxCoeff(), tolerance)
      << actual.transpose() << " instead of " << expected.transpose();
}

Point3 randomPoint(double reach) {
  const auto coordinate = [reach] { return *rc::gen::inRange(-1000000, 1000000) * reach * 1e-6; };
  return {coordinate(), coordinate(), coordinate()};
}

AffineMap randomRotation() {
  const Point3 axis = randomPoint(1.0);
  RC_PRE(axis.norm() > 1e-3);
  return rotation(axis, *rc::gen::inRange(-1800, 1800) * 0.1);
}

TEST(SpaceMap, RotationsTurnAPointAsRodriguesSays) {
  const Point3 p(10.0, 20.0, 30.0);
  const Point3 x = Point3::UnitX();
  expectNear(rotation(x, 45.0).map(p), {10.0, -7.071068, 35.355339}, 1e-6);
  expectNear(rotation(Point3::UnitY(), 45.0).map(p), {28.284271, 20.0, 14.142136}, 1e-6);
  expectNear(rotation(Point3::UnitZ(), 45.0).map(p), {-7.071068, 21.213203, 30.0}, 1e-6);
  expectNear(rotation(x, 30.0).map(p), {10.0, 2.320508, 35.980762}, 1e-6);
  expectNear(rotation(x, 60.0).map(p), {10.0, -15.980762, 32.320508}, 1e-6);
  expectNear(rotation(x, 90.0).map(p), {10.0, -30.0, 20.0}, 1e-6);
  expectNear(rotation(x, -45.0).map(p), {10.0, 35.355339, 7.071068}, 1e-6);
  expectNear(rotation(x, 0.0).map(p), p, 1e-15);
}

TEST(SpaceMap, AnInclinedLayerGrowsTowardsMinusYAboutX) {
  const double half = std::sqrt(0.5);
  expectNear(rotation(Point3::UnitX(), 45.0).map(Point3::UnitY()), {0.0, half, half}, 1e-15);
  expectNear(rotation(Point3::UnitX(), 45.0).map(Point3::UnitZ()), {0.0, -half, half}, 1e-15);
}

TEST(SpaceMap, AZHopStaysAlongTheLayersNormal) {
  expectNear(rotation(Point3::UnitX(), 45.0).map({0.0, 0.0, 3.0}), {0.0, -2.121320, 2.121320}, 1e-6);
}

TEST(SpaceMap, RotationsAreProperAndUndoneByTheOppositeAngle) {
  EXPECT_TRUE(rc::check([] {
    const AffineMap turn = randomRotation();
    const Eigen::Matrix3d matrix = turn.matrix().linear();
    RC_ASSERT((matrix * matrix.transpose()).isIdentity(1e-12));
    RC_ASSERT(std::abs(matrix.determinant() - 1.0) < 1e-12);
    RC_ASSERT(turn.kind() == MapKind::Isometry);
    const Point3 point = randomPoint(3000.0);
    RC_ASSERT((turn.inverse(turn.map(point)) - point).norm() < kRoundTrip);
  }));
}

TEST(SpaceMap, EveryMapIsUndoneByItsInverse) {
  EXPECT_TRUE(rc::check([] {
    const double factor = *rc::gen::inRange(100, 4000) * 1e-3;
    const AffineMap maps[] = {scaling({factor, 1.0, 1.0 / factor}), shear(1, 2, factor - 2.0),
                              beltAxes(15.0 + 18.0 * factor), shear(0, 2, 1.0) * randomRotation()};
    const Point3 point = randomPoint(2500.0);
    for (const AffineMap& map : maps) {
      RC_ASSERT((map.inverse(map.map(point)) - point).norm() < kRoundTrip);
      RC_ASSERT((map.map(map.inverse(point)) - point).norm() < kRoundTrip);
    }
  }));
}

TEST(SpaceMap, ProductsApplyTheRightOneFirst) {
  const AffineMap both = scaling({2.0, 1.0, 1.0}) * rotation(Point3::UnitZ(), 90.0);
  expectNear(both.map({0.0, -3.0, 1.0}), {6.0, 0.0, 1.0}, 1e-12);
}

TEST(SpaceMap, KindAndVolumeReportWhatIsKept) {
  EXPECT_EQ(shear(1, 2, 0.5).kind(), MapKind::Affine);
  EXPECT_NEAR(shear(1, 2, 0.5).volumeRatio({1.0, 2.0, 3.0}), 1.0, 1e-12);
  EXPECT_NEAR(scaling({2.0, 3.0, 4.0}).volumeRatio({}), 24.0, 1e-12);
  EXPECT_EQ(scaling({1.0, 1.0, -1.0}).kind(), MapKind::Isometry);
  EXPECT_EQ((rotation({1.0, 2.0, 3.0}, 33.0) * rotation({3.0, 0.0, 1.0}, 12.0)).kind(), MapKind::Isometry);
}

/// A pipe bent along a parabola.
class Bend final : public SpaceMap {
 public:
  Point3 map(const Point3& p) const override { return {2.0 * p.x(), p.y() + 0.01 * p.x() * p.x(), p.z()}; }
  Point3 inverse(const Point3& p) const override {
    return {0.5 * p.x(), p.y() - 0.0025 * p.x() * p.x(), p.z()};
  }
};

TEST(SpaceMap, TheVolumeOfACurvedMapIsMeasured) {
  EXPECT_NEAR(Bend().volumeRatio({10.0, 20.0, 30.0}), 2.0, 1e-6);
  expectNear(Bend().inverse(Bend().map({10.0, 20.0, 30.0})), {10.0, 20.0, 30.0}, kRoundTrip);
}

TEST(SpaceMap, BeltAxesAreThoseOfTheLeaningGantry) {
  // Halfway up a gantry leaning at 30 deg, one up is two along it, and the belt goes on by sqrt(3).
  expectNear(beltAxes(30.0).map({7.0, 5.0, 1.0}), {7.0, 2.0, std::sqrt(3.0) - 5.0}, 1e-12);
  expectNear(beltAxes(90.0).map({7.0, 5.0, 1.0}), {7.0, 1.0, -5.0}, 1e-12);
}

TEST(SpaceMap, WhatCannotBeInvertedIsRefused) {
  EXPECT_THROW(scaling({1.0, 0.0, 1.0}), InvalidInput);
  EXPECT_THROW(scaling({1.0, NAN, 1.0}), InvalidInput);
  EXPECT_THROW(rotation(Point3::Zero(), 45.0), InvalidInput);
  EXPECT_THROW(shear(1, 1, 0.5), InvalidInput);
  EXPECT_THROW(beltAxes(10.0), InvalidInput);
}

}  // namespace
}  // namespace lamina
