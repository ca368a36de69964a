// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Arms whose wrist is not spherical: all solutions, exactly, by class.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "lamina/geometry/vector.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "support/arms.hpp"

namespace lamina {
namespace {

constexpr double kRoundTripOfTip = 1e-9;  // m: 1e-6 mm
constexpr double kRegular = 0.02;         // sine: at least 1 deg from singular

struct Tally {
  int missed = 0;
  int poses = 0;
  std::map<std::size_t, int> by_count;
};

void expectLeadsBack(const KinematicModel& arm, const InverseSolutions& solutions,
                     const Eigen::Isometry3d& pose) {
  std::set<int> branches;
  for (const InverseSolution& solution : solutions) {
    ASSERT_LT(test::distance(arm.bedFromNozzle(solution.values), pose), kRoundTripOfTip);
    ASSERT_TRUE(branches.insert(solution.branch).second) << "branch " << solution.branch << " twice";
    ASSERT_LE(solution.values.maxCoeff(), M_PI);
    ASSERT_GT(solution.values.minCoeff(), -M_PI);
  }
}

Tally tallyOf(const KinematicModel& arm, int poses) {
  Tally tally;
  Random random(17);
  while (tally.poses < poses) {
    const JointValues values = test::anyJointValues(arm, random);
    if (arm.singularityMargin(values) < kRegular) continue;
    ++tally.poses;
    const Eigen::Isometry3d pose = arm.bedFromNozzle(values);
    const InverseSolutions solutions = arm.solutions(pose, JointValues::Zero(6));
    expectLeadsBack(arm, solutions, pose);
    ++tally.by_count[solutions.size()];
    const bool is_found = std::any_of(solutions.begin(), solutions.end(), [&](const InverseSolution& each) {
      return test::turnDistance(each.values, values) < 1e-6;
    });
    tally.missed += is_found ? 0 : 1;
  }
  return tally;
}

TEST(ArmClasses, ThreeParallelAxesHaveTwoFourOrEightSolutionsAndNoneIsMissed) {
  for (const auto& description : {test::parallelAxesArm(), test::exactParallelAxesArm()}) {
    const auto arm = kinematicModelFromUrdf(description.urdf());
    const Tally tally = tallyOf(*arm, 20000);
    EXPECT_EQ(tally.missed, 0);
    // Every way of axis 1 and 5 has an even number of ways of the triangle.
    for (const auto& [count, poses] : tally.by_count)
      EXPECT_TRUE(count % 2 == 0 && count >= 2 && count <= 8) << count;
    EXPECT_GT(tally.by_count.at(8), 1000);
  }
}

TEST(ArmClasses, WristsWithAnOffsetHaveAllTheirSolutions) {
  for (const auto& description : {test::asideWristArm(), test::raisedWristArm()}) {
    const auto arm = kinematicModelFromUrdf(description.urdf());
    const Tally tally = tallyOf(*arm, 20000);
    // Two roots may hide between samples of joint 6, above all where the reach ends between these: 2 of 1000.
    EXPECT_EQ(tally.missed, 0);
    // Roots of a periodic function: an even number, but for some of a pose whose other solutions are
    // singular.
    int odd = 0;
    for (const auto& [count, poses] : tally.by_count) odd += count % 2 == 1 ? poses : 0;
    EXPECT_LE(odd, 20);
    EXPECT_GE(tally.by_count.rbegin()->first, 8U);
    EXPECT_LE(tally.by_count.rbegin()->first, 16U);
  }
}

TEST(ArmClasses, ABranchIsSteadyAlongASmoothMotion) {
  const auto arm = kinematicModelFromUrdf(test::exactParallelAxesArm().urdf());
  // A joint goes by 1e-2 rad a step, ten times that near a singularity, and joint 4 by the sum of them.
  Random random(3);
  for (int motion = 0; motion < 50; ++motion) {
    const JointValues from = test::anyJointValues(*arm, random);
    const JointValues to = from + 0.3 * (test::anyJointValues(*arm, random) - from);
    std::map<int, JointValues> before;
    for (int i = 0; i <= 200; ++i) {
      const JointValues values = from + i / 200.0 * (to - from);
      std::map<int, JointValues> now;
      for (const auto& [branch, found] : arm->solutions(arm->bedFromNozzle(values), values)) {
        if (arm->singularityMargin(found) < 0.1) continue;
        now[branch] = found;
        if (before.count(branch) != 0) {
          EXPECT_LT(test::turnDistance(found, before[branch]), 0.5);
        }
      }
      before = now;
    }
  }
}

TEST(ArmClasses, OutOfReachThereIsNoSolution) {
  for (const auto& description : {test::exactParallelAxesArm(), test::asideWristArm()}) {
    const auto arm = kinematicModelFromUrdf(description.urdf());
    Eigen::Isometry3d pose = arm->bedFromNozzle(JointValues::Constant(6, 0.4));
    pose.translation() += Point3(0.0, 0.0, 5000.0);
    EXPECT_TRUE(arm->solutions(pose, JointValues::Zero(6)).empty());
  }
}

}  // namespace
}  // namespace lamina
