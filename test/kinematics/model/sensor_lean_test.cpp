// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/model/sensor_lean.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

const Eigen::Quaterniond kInclined(Eigen::AngleAxisd(0.25 * M_PI, Point3::UnitX()));

TEST(SensorLean, IsNoneOfASensorThatLooksSquareToTheLayers) {
  EXPECT_EQ(sensorLean(buildSpaceByName("cartesian_gantry")), Point2(0, 0));
  EXPECT_EQ(sensorLean(buildSpaceByName("gantry_45")), Point2(0, 0)) << "over level layers";
  EXPECT_EQ(sensorLean(buildSpaceByName("belt_45"), kInclined), Point2(0, 0)) << "along the tool axis";
  EXPECT_EQ(sensorLean(buildSpaceByName("irb_4600")), Point2(0, 0)) << "without a sensor";
}

/// Straight down, in layers that stand at 45 deg: as far towards their foot as down.
TEST(SensorLean, OfASensorThatLooksStraightDownIsTheTangentOfTheIncline) {
  EXPECT_TRUE(sensorLean(buildSpaceByName("gantry_45"), kInclined).isApprox(Point2(0, -1), 1e-9));
  const Eigen::Quaterniond steep(Eigen::AngleAxisd(M_PI / 3.0, Point3::UnitX()));
  EXPECT_TRUE(sensorLean(buildSpaceByName("gantry_45"), steep).isApprox(Point2(0, -std::sqrt(3.0)), 1e-9));
}

TEST(SensorLean, RefusesASensorThatLooksUp) {
  BuildSpace upwards = buildSpaceByName("cartesian_gantry");
  upwards.tip_from_sensor = Eigen::Isometry3d::Identity();
  EXPECT_THROW(sensorLean(upwards), InvalidConfig);
}

}  // namespace
}  // namespace lamina
