// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/platform/rus_kinematics.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "kinematics/arm/hunt_poses.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"

namespace lamina {
namespace {

constexpr double kExactPose = 1e-6;  // mm: 1e-9 m

/// A leg in the plane of x and z: crank 3, coupler 5.
RusLeg planeLeg() {
  RusLeg leg;
  leg.axis = -Point3::UnitY();
  leg.rest = Point3::UnitX();
  leg.crank_mm = 3.0;
  leg.coupler_mm = 5.0;
  return leg;
}

double poseError(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

std::string rusKinematicsUnreachable(const Eigen::Isometry3d& pose) {
  try {
    crankAngles(huntPlatform(), pose);
    return "";
  } catch (const Unreachable& error) {
    return error.what();
  }
}

TEST(RusKinematics, HexagonsHaveTheRadiiOfTheirEdges) {
  EXPECT_NEAR(hexagonRadius(350, 150), 256.6, 0.05);
  EXPECT_NEAR(hexagonRadius(200, 50), 132.3, 0.05);
  EXPECT_DOUBLE_EQ(hexagonRadius(10, 10), 10.0);
  const RusPlatform platform = huntPlatform();
  EXPECT_NEAR((platform.legs[1].motor - platform.legs[0].motor).norm(), 150.0, 1e-9);
  EXPECT_NEAR((platform.legs[2].motor - platform.legs[1].motor).norm(), 350.0, 1e-9);
  EXPECT_NEAR((platform.legs[1].ball - platform.legs[0].ball).norm(), 50.0, 1e-9);
  EXPECT_NEAR((platform.legs[2].ball - platform.legs[1].ball).norm(), 200.0, 1e-9);
}

TEST(RusKinematics, CrankOfARightTriangleStandsUprightOrMirrored) {
  // Crank up to (0, 3), coupler from there to (4, 0); its mirror image is at the line's other side.
  const RusLeg leg = planeLeg();
  EXPECT_NEAR(*crankAngle(leg, {4, 0, 0}, CrankBranch::Ahead), M_PI / 2, 1e-12);
  EXPECT_NEAR(*crankAngle(leg, {4, 0, 0}, CrankBranch::Behind), -M_PI / 2, 1e-12);
}

TEST(RusKinematics, BallAsideOfTheCranksPlaneIsReachedByAShorterTriangle) {
  // The coupler leans by 3 out of the plane, so 4 of its 5 are left: stretched at 3 + 4.
  const RusLeg leg = planeLeg();
  EXPECT_NEAR(*crankAngle(leg, {7.0 - 1e-12, 3, 0}, CrankBranch::Ahead), 0.0, 1e-5);
  EXPECT_FALSE(crankAngle(leg, {7.0 + 1e-9, 3, 0}, CrankBranch::Ahead));
  EXPECT_FALSE(crankAngle(leg, {1.0 - 1e-9, 3, 0}, CrankBranch::Ahead)) << "folded";
  EXPECT_FALSE(crankAngle(leg, {0, 0, 0}, CrankBranch::Ahead)) << "no direction";
}

TEST(RusKinematics, LegsAreAsLongAsTheyAreInBothBranches) {
  EXPECT_TRUE(rc::check("from the end of the crank to the ball it is the coupler", [](std::uint64_t seed) {
    Random random(seed);
    const RusPlatform platform = huntPlatform();
    const Eigen::Isometry3d pose = randomPose(random);
    for (const RusLeg& leg : platform.legs)
      for (const CrankBranch branch : {CrankBranch::Behind, CrankBranch::Ahead}) {
        const auto crank = crankAngle(leg, pose * leg.ball, branch);
        RC_ASSERT(crank.has_value());
        RC_ASSERT(std::abs((pose * leg.ball - leg.elbow(*crank)).norm() - 340.0) < 1e-10);
      }
  }));
}

TEST(RusKinematics, ForwardAnswersInverseOverTheWorkspace) {
  EXPECT_TRUE(
      rc::check("the pose comes back from its cranks, from home and from nearby", [](std::uint64_t seed) {
        Random random(seed);
        const RusPlatform platform = huntPlatform();
        const Eigen::Isometry3d pose = randomPose(random);
        const CrankAngles cranks = crankAngles(platform, pose);
        RC_ASSERT(poseError(poseFromHome(platform, cranks), pose) < kExactPose * 1e-3);
        Eigen::Isometry3d near = pose;
        near.translation() += Point3(2, -1, 1);
        const auto found = poseNear(platform, cranks, near);
        RC_ASSERT(found.has_value());
        RC_ASSERT(poseError(*found, pose) < kExactPose * 1e-3);
      }));
}

TEST(RusKinematics, InverseAnswersForwardOverTheCranks) {
  EXPECT_TRUE(rc::check("the cranks come back from the pose they give", [](std::uint64_t seed) {
    Random random(seed);
    const RusPlatform platform = huntPlatform();
    CrankAngles cranks = crankAngles(platform, platform.home);
    for (double& crank : cranks) crank += random.uniform(-0.35, 0.35);
    const Eigen::Isometry3d pose = poseFromHome(platform, cranks);
    RC_ASSERT((crankAngles(platform, pose) - cranks).cwiseAbs().maxCoeff() < 1e-9);
  }));
}

TEST(RusKinematics, PosesOutOfReachNameEveryLegThatFails) {
  Eigen::Isometry3d pose = huntPlatform().home;
  pose.translation().z() = -600.0;
  const std::string low = rusKinematicsUnreachable(pose);
  for (int leg = 1; leg <= 6; ++leg)
    EXPECT_NE(low.find("leg " + std::to_string(leg)), std::string::npos) << low;
  pose.translation() = Point3(-330, 0, -260);
  const std::string aside = rusKinematicsUnreachable(pose);
  EXPECT_NE(aside.find("leg 1"), std::string::npos) << aside;
  EXPECT_EQ(aside.find("leg 3"), std::string::npos) << aside;
  EXPECT_NE(aside.find("mm from motor to ball"), std::string::npos) << aside;
}

TEST(RusKinematics, CranksThatCannotBeClosedAreRefused) {
  const RusPlatform platform = huntPlatform();
  CrankAngles cranks = crankAngles(platform, platform.home);
  cranks[0] += M_PI;
  cranks[2] += M_PI;
  cranks[4] += M_PI;
  cranks[5] -= 2.0;
  EXPECT_THROW(poseFromHome(platform, cranks), Unreachable);
}

TEST(RusKinematics, VelocityEquationIsTheSlopeOfTheInverse) {
  EXPECT_TRUE(rc::check("differences of the cranks' angles", [](std::uint64_t seed) {
    Random random(seed);
    const RusPlatform platform = huntPlatform();
    const Eigen::Isometry3d pose = randomPose(random);
    const VelocityEquation equation = velocityEquation(platform, pose, crankAngles(platform, pose));
    const double step = 1e-4;
    for (int along = 0; along < 6; ++along) {
      CrankAngles twist = CrankAngles::Zero();
      twist[along] = along < 3 ? 1.0 : 0.01;
      const CrankAngles slope = (crankAngles(platform, carried(pose, step * twist)) -
                                 crankAngles(platform, carried(pose, -step * twist))) /
                                (2.0 * step);
      const CrankAngles expected = (equation.pose_rates * twist).cwiseQuotient(equation.crank_rates);
      RC_ASSERT((slope - expected).cwiseAbs().maxCoeff() < 1e-7);
    }
  }));
}

TEST(RusKinematics, StretchedLegIsASingularityOfTypeOne) {
  // Leg 1 straight out: crank and coupler in one line.
  RusPlatform platform = huntPlatform();
  CrankAngles cranks = crankAngles(platform, platform.home);
  EXPECT_GT(singularityMargins(platform, platform.home, cranks).least(), 0.3);
  RusLeg& leg = platform.legs[0];
  leg.motor = platform.home * leg.ball - (leg.crank_mm + leg.coupler_mm) * leg.crankDirection(0.4);
  cranks[0] = 0.4;
  EXPECT_NEAR(singularityMargins(platform, platform.home, cranks).stretched, 0.0, 1e-9);
}

TEST(RusKinematics, CouplersInParallelDoNotHoldThePlatform) {
  // Six couplers hang straight down from a ring of cranks as wide as the platform: it may slide aside.
  RusPlatform platform = huntPlatform();
  for (RusLeg& leg : platform.legs) {
    leg.motor = leg.ball - leg.crank_mm * leg.rest;
    leg.axis = leg.rest.cross(Point3::UnitZ());
  }
  platform.home.translation() = Point3(0, 0, -340);
  const SingularityMargins margins = singularityMargins(platform, platform.home, CrankAngles::Zero());
  EXPECT_NEAR(margins.unheld, 0.0, 1e-9);
  EXPECT_NEAR(margins.stretched, 1.0, 1e-9);
  EXPECT_NEAR(margins.least(), 0.0, 1e-9);
}

TEST(RusKinematics, AnglesAreThoseOfTheSource) {
  EXPECT_NEAR(platformAngles(Eigen::Matrix3d::Identity()).alpha, 0.0, 1e-15);
  EXPECT_NEAR(platformAngles(Eigen::Matrix3d::Identity()).beta, 0.0, 1e-15);
  EXPECT_TRUE(
      rc::check("alpha = asin n_y, beta = atan2(-n_x, -n_z), R (0, 0, -1) = n", [](std::uint64_t seed) {
        Random random(seed);
        Point3 n(random.normal(0, 1), random.normal(0, 1), -std::abs(random.normal(0, 1)) - 0.05);
        n.normalize();
        const double gamma = random.uniform(-3.0, 3.0);
        const PlatformAngles angles{std::asin(n.y()), std::atan2(-n.x(), -n.z()), gamma};
        const Eigen::Matrix3d rotation = rotationOf(angles);
        RC_ASSERT((rotation * Point3(0, 0, -1) - n).norm() < 1e-12);
        const PlatformAngles back = platformAngles(rotation);
        RC_ASSERT(std::abs(back.alpha - angles.alpha) < 1e-9);
        RC_ASSERT(std::abs(back.beta - angles.beta) < 1e-9);
        RC_ASSERT(std::abs(back.gamma - angles.gamma) < 1e-9);
      }));
  const Eigen::Matrix3d upright = rotationOf({M_PI / 2, 0.7, 0.0});
  EXPECT_TRUE(rotationOf(platformAngles(upright)).isApprox(upright, 1e-9)) << "where beta and gamma are one";
}

}  // namespace
}  // namespace lamina
