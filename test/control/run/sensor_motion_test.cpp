// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/sensor_motion.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

constexpr std::int64_t kSecondNs = 1'000'000'000;

TEST(SensorMotion, IsKnownBetweenCloudsThatAreNear) {
  SensorMotion motion;
  EXPECT_EQ(motion.velocity(), Eigen::Vector3d::Zero());
  motion.see(kSecondNs, Point3(1.0, 0.0, 0.0));
  EXPECT_EQ(motion.velocity(), Eigen::Vector3d::Zero()) << "of one cloud nothing follows";
  motion.see(kSecondNs + kSecondNs / 4, Point3(2.0, 1.0, 0.0));
  EXPECT_EQ(motion.velocity(), Eigen::Vector3d(4.0, 4.0, 0.0));
  motion.see(kSecondNs + kSecondNs / 4, Point3(9.0, 1.0, 0.0));
  EXPECT_EQ(motion.velocity(), Eigen::Vector3d::Zero()) << "at the same time";
  motion.see(2 * kSecondNs, Point3(10.0, 1.0, 0.0));
  EXPECT_EQ(motion.velocity(), Eigen::Vector3d::Zero()) << "0.75 s later";
}

}  // namespace
}  // namespace lamina
