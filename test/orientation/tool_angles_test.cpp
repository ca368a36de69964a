// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/orientation/tool_angles.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <Eigen/Geometry>
#include <cmath>

#include "support/directions.hpp"

namespace lamina {
namespace {

TEST(ToolAngles, AVerticalToolAxisHasNone) {
  const ToolAngles angles = toolAngles(Point3(0, 0, -1));
  EXPECT_EQ(angles.alpha, 0.0);
  EXPECT_EQ(angles.beta, 0.0);
}

TEST(ToolAngles, AreThoseOfTheSource) {
  EXPECT_TRUE(rc::check([] {
    const Point3 n = test::anyToolAxis(89.0);
    const ToolAngles angles = toolAngles(n);
    RC_ASSERT(std::abs(angles.alpha - std::asin(n.y())) <= 1e-9);
    RC_ASSERT(std::abs(angles.beta - std::atan2(-n.x(), -n.z())) <= 1e-12);
  }));
}

TEST(ToolAngles, TheTwoTurnsMakeTheToolAxis) {
  EXPECT_TRUE(rc::check([] {
    const Point3 n = test::anyToolAxis(180.0);
    const ToolAngles angles = toolAngles(n);
    const Eigen::Matrix3d turn =
        (Eigen::AngleAxisd(angles.beta, Point3::UnitY()) * Eigen::AngleAxisd(angles.alpha, Point3::UnitX()))
            .toRotationMatrix();
    RC_ASSERT((turn * Point3(0, 0, -1) - n).norm() <= 1e-12);
    RC_ASSERT((toolAxisOf(angles) - n).norm() <= 1e-12);
  }));
}

TEST(ToolAngles, AlongYTheSecondTurnIsZero) {
  const ToolAngles angles = toolAngles(Point3(0, -1, 0));
  EXPECT_DOUBLE_EQ(angles.alpha, -M_PI / 2.0);
  EXPECT_EQ(angles.beta, 0.0);
}

}  // namespace
}  // namespace lamina
