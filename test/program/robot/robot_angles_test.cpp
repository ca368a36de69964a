// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/program/robot/robot_angles.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/random.hpp"
#include "lamina/geometry/vector.hpp"

namespace lamina {
namespace {

constexpr double kQuarter = M_SQRT1_2;  // sine and cosine of 45 deg

void expectAngles(const Eigen::Quaterniond& turn, double x_deg, double y_deg, double z_deg,
                  double tolerance) {
  const RobotAngles angles = robotAngles(turn);
  EXPECT_NEAR(angles.x_deg, x_deg, tolerance);
  EXPECT_NEAR(angles.y_deg, y_deg, tolerance);
  EXPECT_NEAR(angles.z_deg, z_deg, tolerance);
}

// Axes of the turned frame, worked out by hand: Rz(90) carries x to y and y to -x.
TEST(RobotAngles, TurnAboutFixedAxesXThenYThenZ) {
  const Eigen::Matrix3d about_z = rotationOfAngles(RobotAngles{0.0, 0.0, 90.0}).toRotationMatrix();
  EXPECT_TRUE(about_z.col(0).isApprox(Point3(0, 1, 0), 1e-12));
  EXPECT_TRUE(about_z.col(1).isApprox(Point3(-1, 0, 0), 1e-12));
  // First by 90 deg about x: y to z, z to -y. Then about the fixed z: -y to x. The tool axis is along x.
  const Eigen::Matrix3d both = rotationOfAngles(RobotAngles{90.0, 0.0, 90.0}).toRotationMatrix();
  EXPECT_TRUE(both.col(0).isApprox(Point3(0, 1, 0), 1e-12));
  EXPECT_TRUE(both.col(1).isApprox(Point3(0, 0, 1), 1e-12));
  EXPECT_TRUE(both.col(2).isApprox(Point3(1, 0, 0), 1e-12));
}

TEST(RobotAngles, OfTurnsAboutOneAxis) {
  expectAngles(Eigen::Quaterniond(0, 1, 0, 0), 180.0, 0.0, 0.0, 1e-12);                // tool straight down
  expectAngles(Eigen::Quaterniond(kQuarter, kQuarter, 0, 0), 90.0, 0.0, 0.0, 1e-9);    // about x
  expectAngles(Eigen::Quaterniond(kQuarter, 0, 0, -kQuarter), 0.0, 0.0, -90.0, 1e-9);  // about z
  // 30 deg about y: sine and cosine of 15 deg.
  expectAngles(Eigen::Quaterniond(0.9659258262890683, 0, 0.2588190451025207, 0), 0.0, 30.0, 0.0, 1e-9);
}

// Poses of robots at joints 10, -20, 30, -40, 50, -60 deg, from their descriptions.
TEST(RobotAngles, AreThoseOfPublicRobots) {
  // KR 16-2: A 100.3850, B -21.8550, C 137.9810.
  expectAngles(Eigen::Quaterniond(0.089422, 0.639024, 0.660615, 0.383718), 137.981, -21.855, 100.385, 5e-4);
  // M-20iA: W 1.812, P 29.536, R -80.551.
  expectAngles(Eigen::Quaterniond(0.735042, 0.176434, 0.184574, -0.628106), 1.812, 29.536, -80.551, 5e-4);
}

TEST(RobotAngles, KeepXWhereXAndZTurnAboutOneAxis) {
  // By 90 deg about y: z goes to x, x to -z.
  const Eigen::Quaterniond up(kQuarter, 0, kQuarter, 0);
  const RobotAngles plain = robotAngles(up, 0.0);
  EXPECT_NEAR(plain.x_deg, 0.0, 1e-9);
  EXPECT_EQ(plain.y_deg, 90.0);
  EXPECT_NEAR(plain.z_deg, 0.0, 1e-9);
  // Rz(z) Ry(90) Rx(x) depends on z - x alone.
  const RobotAngles kept = robotAngles(up, 35.0);
  EXPECT_EQ(kept.x_deg, 35.0);
  EXPECT_NEAR(kept.z_deg, 35.0, 1e-9);
  EXPECT_LT(rotationOfAngles(kept).angularDistance(up), 1e-9);
  // At -90 deg it depends on z + x.
  const Eigen::Quaterniond down(kQuarter, 0, -kQuarter, 0);
  const RobotAngles below = robotAngles(down, 35.0);
  EXPECT_EQ(below.y_deg, -90.0);
  EXPECT_EQ(below.x_deg, 35.0);
  EXPECT_NEAR(below.z_deg, -35.0, 1e-9);
  EXPECT_LT(rotationOfAngles(below).angularDistance(down), 1e-9);
}

TEST(RobotAngles, GiveTheTurnBackAsRoundedAndAlsoCloseToWhereTheyAreNotUnique) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    RobotAngles angles{random.uniform(-180.0, 180.0), random.uniform(-90.0, 90.0),
                       random.uniform(-180.0, 180.0)};
    if (random.below(2) == 0)
      angles.y_deg = (random.below(2) == 0 ? 90.0 : -90.0) + random.uniform(-1e-4, 1e-4);
    const Eigen::Quaterniond turn = rotationOfAngles(angles);
    RobotAngles found = robotAngles(turn, random.uniform(-180.0, 180.0));
    RC_ASSERT(found.y_deg >= -90.0 && found.y_deg <= 90.0);
    for (double* angle : {&found.x_deg, &found.y_deg, &found.z_deg}) *angle = std::round(*angle * 1e4) * 1e-4;
    // Half of the last decimal about each of three axes.
    RC_ASSERT(rotationOfAngles(found).angularDistance(turn) * 180.0 / M_PI <= 2e-4);
  }));
}

TEST(RobotAngles, RotationVectorsAreAxesOfTheLengthOfTheirAngle) {
  EXPECT_TRUE(rotationVector(Eigen::Quaterniond(1, 0, 0, 0)).isZero(0.0));
  EXPECT_TRUE(
      rotationVector(Eigen::Quaterniond(kQuarter, 0, kQuarter, 0)).isApprox(Point3(0, M_PI / 2, 0), 1e-12));
  // Half turns: one of two axes, always the same.
  EXPECT_TRUE(rotationVector(Eigen::Quaterniond(0, -1, 0, 0)).isApprox(Point3(M_PI, 0, 0), 1e-12));
  EXPECT_TRUE(rotationVector(Eigen::Quaterniond(0, 1, 0, 0)).isApprox(Point3(M_PI, 0, 0), 1e-12));
  // UR10e in base_link, seen from base, which is turned by 180 deg about z.
  const Eigen::Quaterniond in_base =
      Eigen::Quaterniond(0, 0, 0, 1) * Eigen::Quaterniond(0.706231, -0.210110, 0.514143, 0.439032);
  EXPECT_TRUE(rotationVector(in_base).isApprox(Point3(1.277558, 0.522089, -1.754865), 2e-6));
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    const Eigen::Quaterniond turn = rotationOfAngles(RobotAngles{
        random.uniform(-180.0, 180.0), random.uniform(-90.0, 90.0), random.uniform(-180.0, 180.0)});
    const Eigen::Vector3d vector = rotationVector(turn);
    RC_ASSERT(vector.norm() <= M_PI + 1e-12);
    RC_ASSERT(rotationOfVector(vector).angularDistance(turn) < 1e-9);
  }));
}

}  // namespace
}  // namespace lamina
