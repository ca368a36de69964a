// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/arm/spherical_wrist_arm.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "support/arms.hpp"

namespace lamina {
namespace {

using Axes = std::array<Screw, 6>;

Eigen::Isometry3d moved(const Screw& screw, double angle) {
  return Eigen::Translation3d(screw.point) * Eigen::AngleAxisd(angle, screw.direction) *
         Eigen::Translation3d(-screw.point);
}

Eigen::Isometry3d forward(const Axes& axes, const Eigen::Isometry3d& at_zero, const ArmValues& values) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (std::size_t j = 0; j < 6; ++j) pose = pose * moved(axes[j], values[static_cast<Eigen::Index>(j)]);
  return pose * at_zero;
}

ArmValues anyArmValues(Random& random) {
  return ArmValues::NullaryExpr([&] { return random.uniform(-M_PI, M_PI); });
}

Eigen::Isometry3d anyPose(Random& random) {
  const auto part = [&] { return random.uniform(-1.0, 1.0); };
  Eigen::Isometry3d pose(Eigen::Quaterniond(part(), part(), part(), part()).normalized());
  pose.translation() = 1000.0 * Point3(part(), part(), part());
  return pose;
}

struct AnyArm {
  Axes axes;
  Eigen::Isometry3d at_zero;
};

/// Any arm of the kind, with any sense of its axes and places on them, any zero and any place in the world.
AnyArm anyArm(Random& random) {
  const auto along = [&] { return random.uniform(-300.0, 300.0); };
  const auto sense = [&] { return random.below(2) == 0 ? 1.0 : -1.0; };
  const double shoulder = random.below(3) == 0 ? 0.0 : along();
  const double side = random.below(2) == 0 ? 0.0 : along();
  const Point3 elbow(shoulder, 0.0, random.uniform(300.0, 1200.0));
  const Point3 wrist = elbow + Point3(random.uniform(300.0, 1200.0), side, along());
  const Point3 x = Point3::UnitX();
  const Point3 y = Point3::UnitY();
  const Axes upright = {Screw{sense() * Point3::UnitZ(), Point3(0, 0, along())},
                        Screw{sense() * y, Point3(shoulder, along(), 0)},
                        Screw{sense() * y, elbow + along() * y},
                        Screw{sense() * x, wrist + along() * x},
                        Screw{sense() * y, wrist},
                        Screw{sense() * x, wrist}};
  const Eigen::Isometry3d nozzle = Eigen::Translation3d(wrist) * anyPose(random);
  const ArmValues zero = anyArmValues(random);
  AnyArm arm;
  Eigen::Isometry3d placed = anyPose(random);
  for (std::size_t j = 0; j < 6; ++j) {
    arm.axes[j] = {placed.linear() * upright[j].direction, placed * upright[j].point};
    placed = placed * moved(upright[j], zero[static_cast<Eigen::Index>(j)]);
  }
  arm.at_zero = placed * nozzle;
  return arm;
}

TEST(SphericalWristArm, AnyArmOfTheKindIsSolvedWhateverItsZeroAndSenses) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    const AnyArm any = anyArm(random);
    const auto arm = sphericalWristArm(any.axes, any.at_zero);
    RC_ASSERT(arm.has_value());
    const ArmValues values = anyArmValues(random);
    const Eigen::Isometry3d pose = forward(any.axes, any.at_zero, values);
    bool is_found = false;
    for (const ArmSolution& solution : solutions(*arm, pose, values)) {
      RC_ASSERT(test::distance(forward(any.axes, any.at_zero, solution.values), pose) < 1e-9);
      const bool is_it = test::turnDistance(JointValues(solution.values), JointValues(values)) < 1e-6;
      is_found = is_found || is_it;
    }
    RC_ASSERT(is_found);
  }));
}

TEST(SphericalWristArm, ABranchIsTheSignsOfItsSines) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    const AnyArm any = anyArm(random);
    const auto arm = sphericalWristArm(any.axes, any.at_zero);
    const ArmValues values = anyArmValues(random);
    for (const ArmSolution& solution : solutions(*arm, forward(any.axes, any.at_zero, values), values))
      RC_ASSERT(branchOf(singularSines(*arm, solution.values)) == solution.branch);
  }));
}

TEST(SphericalWristArm, WhatStandsOffIsNoArmOfTheKind) {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const AnyArm any = anyArm(random);
    Axes twisted = any.axes;
    const Eigen::AngleAxisd tilt(0.01, any.axes[1].direction.cross(any.axes[0].direction).normalized());
    twisted[2].direction = tilt * any.axes[2].direction;
    EXPECT_FALSE(sphericalWristArm(twisted, any.at_zero).has_value());
    Axes apart = any.axes;
    apart[5].point += any.axes[4].direction;
    EXPECT_FALSE(sphericalWristArm(apart, any.at_zero).has_value());
  }
}

}  // namespace
}  // namespace lamina
