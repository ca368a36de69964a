// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "toolpath/bead_space.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

TEST(BeadSpace, LiesBelowTheTipOfAnUprightNozzle) {
  Path path;
  path.points = {{1, 2, 3}};
  path.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(M_PI, Point3::UnitX()));
  EXPECT_LT((upAt(path, 0) - Point3::UnitZ()).norm(), 1e-12);
  EXPECT_LT((sectionMiddle(path.points[0], 0.4, upAt(path, 0)) - Point3(1, 2, 2.8)).norm(), 1e-12);
}

TEST(BeadSpace, OutlinesAWideAndAHighSection) {
  const SectionOutline wide = sectionOutline({0.6, 0.2});
  EXPECT_DOUBLE_EQ(wide.radius_mm, 0.1);
  EXPECT_DOUBLE_EQ(wide.flat_across_mm, 0.2);
  EXPECT_DOUBLE_EQ(wide.flat_up_mm, 0.0);
  const SectionOutline high = sectionOutline({0.2, 0.6});
  EXPECT_DOUBLE_EQ(high.flat_across_mm, 0.0);
  EXPECT_DOUBLE_EQ(high.flat_up_mm, 0.2);
}

TEST(BeadSpace, HasAxesAlongTheBeadAndOffTheLayer) {
  EXPECT_TRUE(rc::check("any bead on any layer", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const auto direction = [&random] {
      return Point3(random.normal(0, 1), random.normal(0, 1), random.normal(0, 1)).normalized();
    };
    const Point3 normal = direction();
    const Point3 along = random.uniform(0.1, 9.0) * direction();
    const Eigen::Matrix3d axes = beadAxes(along, normal);
    RC_ASSERT((axes.transpose() * axes - Eigen::Matrix3d::Identity()).norm() < 1e-9);
    RC_ASSERT(axes.determinant() > 0.0);
    RC_ASSERT((axes.col(0) - along.normalized()).norm() < 1e-9);
    RC_ASSERT(std::abs(axes.col(1).dot(normal)) < 1e-9);
    RC_ASSERT(axes.col(2).dot(normal) > -1e-9);
  }));
}

TEST(BeadSpace, StandsOnTheLayerWhereADropGoesNowhere) {
  const Eigen::Matrix3d axes = beadAxes(Point3::Zero(), Point3::UnitY());
  EXPECT_LT((axes.col(2) - Point3::UnitY()).norm(), 1e-12);
  EXPECT_NEAR(axes.determinant(), 1.0, 1e-12);
}

TEST(BeadSpace, GoesAlongTheNormalToo) {
  const Eigen::Matrix3d axes = beadAxes(2.0 * Point3::UnitZ(), Point3::UnitZ());
  EXPECT_LT((axes.col(0) - Point3::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(axes.determinant(), 1.0, 1e-12);
}

}  // namespace
}  // namespace lamina
