// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/platform/rus_workspace.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "kinematics/arm/hunt_poses.hpp"

namespace lamina {
namespace {

/// The one fault of leg 1 at home, if the platform is changed.
FaultyLeg faultAtHome(const RusPlatform& platform) {
  const auto faults = faultyLegs(platform, platform.home);
  return faults.size() == 1 ? faults[0] : FaultyLeg{99, LegFault::OutOfReach, ""};
}

TEST(RusWorkspace, StatedWorkspaceIsWithinAllLimitsAndFarFromSingularities) {
  EXPECT_TRUE(rc::check("no leg is at fault, and the margin is 0.05 at least", [](std::uint64_t seed) {
    Random random(seed);
    const RusPlatform platform = huntPlatform();
    const Eigen::Isometry3d pose = randomPose(random);
    RC_ASSERT(faultyLegs(platform, pose).empty());
    RC_ASSERT(singularityMargins(platform, pose, crankAngles(platform, pose)).least() > 0.05);
  }));
}

TEST(RusWorkspace, PassiveAnglesOfHomeAreTheSameForAllLegs) {
  const RusPlatform platform = huntPlatform();
  const CrankAngles cranks = crankAngles(platform, platform.home);
  const PassiveAngles first = passiveAngles(platform.legs[0], platform.home, cranks[0]);
  EXPECT_NEAR(first.swing, 0.0, 1e-9) << "the sockets look at home";
  for (std::size_t i = 1; i < kLegs; ++i) {
    const PassiveAngles other =
        passiveAngles(platform.legs[i], platform.home, cranks[static_cast<Eigen::Index>(i)]);
    EXPECT_NEAR(other.fold, first.fold, 1e-9);
    EXPECT_NEAR(std::abs(other.lean), std::abs(first.lean), 1e-9);
  }
}

TEST(RusWorkspace, CouplerIsWhereItsAnglesSay) {
  const RusPlatform platform = huntPlatform();
  Random random(7);
  const Eigen::Isometry3d pose = randomPose(random);
  const CrankAngles cranks = crankAngles(platform, pose);
  for (std::size_t i = 0; i < kLegs; ++i) {
    const RusLeg& leg = platform.legs[i];
    const double crank = cranks[static_cast<Eigen::Index>(i)];
    const PassiveAngles angles = passiveAngles(leg, pose, crank);
    const Point3 coupler =
        std::cos(angles.lean) * (leg.crankDirection(crank + angles.fold)) + std::sin(angles.lean) * leg.axis;
    EXPECT_LT((leg.elbow(crank) + 340.0 * coupler - pose * leg.ball).norm(), 1e-9);
  }
}

TEST(RusWorkspace, EachLimitIsNamedWithLegValueAndLimit) {
  RusPlatform platform = huntPlatform();
  platform.legs[0].high = -0.5;
  EXPECT_EQ(faultAtHome(platform).fault, LegFault::Crank);
  EXPECT_EQ(faultAtHome(platform).reason,
            "leg 1: the crank would be at 10.286 deg; it goes from -68.755 to -28.648 deg");
  platform = huntPlatform();
  platform.legs[0].greatest_lean = 0.1;
  EXPECT_EQ(faultAtHome(platform).fault, LegFault::Universal);
  platform = huntPlatform();
  platform.legs[0].socket = Point3::UnitX();
  EXPECT_EQ(faultAtHome(platform).fault, LegFault::Spherical);
  platform = huntPlatform();
  platform.legs[0].coupler_mm = 10.0;
  EXPECT_EQ(faultAtHome(platform).fault, LegFault::OutOfReach);
  EXPECT_EQ(faultAtHome(platform).leg, 0U);
}

TEST(RusWorkspace, EveryLegAtFaultIsListed) {
  Eigen::Isometry3d pose = huntPlatform().home;
  pose.translation().z() = -600.0;
  EXPECT_EQ(faultyLegs(huntPlatform(), pose).size(), 6U);
}

}  // namespace
}  // namespace lamina
