// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/space_vectors.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(SpaceVectors, MeasureAnglesOfDirectionsOfAnyLength) {
  EXPECT_DOUBLE_EQ(angleBetween({3.0, 0.0, 0.0}, {0.0, 0.0, 0.1}), M_PI / 2.0);
  EXPECT_DOUBLE_EQ(angleBetween({1.0, 0.0, 0.0}, {-2.0, 0.0, 0.0}), M_PI);
  EXPECT_DOUBLE_EQ(angleBetween({1.0, 1.0, 0.0}, {1.0, 0.0, 0.0}), M_PI / 4.0);
  EXPECT_EQ(angleBetween({1.0, 1.0, 0.0}, Point3::Zero()), 0.0);
}

TEST(SpaceVectors, TurnByTheirLength) {
  const Point3 turned = turnBy({0.0, 0.0, M_PI / 2.0}) * Point3::UnitX();
  EXPECT_LT((turned - Point3::UnitY()).norm(), 1e-15);
  EXPECT_DOUBLE_EQ(turnBy({0.0, 3.0, 4.0}).angle(), 5.0);
  EXPECT_EQ(turnBy(Point3::Zero()).toRotationMatrix(), Eigen::Matrix3d::Identity());
}

TEST(SpaceVectors, MeasureHowFarAWayIs) {
  const Point3 from(0.0, 0.0, 0.0);
  const Point3 to(4.0, 0.0, 0.0);
  EXPECT_DOUBLE_EQ(distanceToSegment({2.0, 0.0, 3.0}, from, to), 3.0);
  EXPECT_DOUBLE_EQ(distanceToSegment({7.0, 0.0, 4.0}, from, to), 5.0);
  EXPECT_DOUBLE_EQ(distanceToSegment({0.0, 2.0, 0.0}, from, from), 2.0);
}

}  // namespace
}  // namespace lamina
