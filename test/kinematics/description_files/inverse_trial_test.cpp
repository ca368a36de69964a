// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/description_files/inverse_trial.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/arms.hpp"

namespace lamina {
namespace {

/// Of ten poses.
InverseTrial trialOf(std::size_t reached, bool ends) {
  InverseTrial trial;
  trial.poses = 10;
  trial.reached = reached;
  trial.ends = ends;
  return trial;
}

TEST(InverseTrial, OfClosedFormsRecoversAllJointsAndEndsBeyondReach) {
  for (const char* name : {"irb_4600", "irb_4600_turntable"}) {
    const InverseTrial trial = tryInverse(*kinematicModelByName(name), 300);
    EXPECT_EQ(trial.poses, 300U) << name;
    EXPECT_EQ(trial.reached, 300U) << name;
    EXPECT_EQ(trial.recovered, 300U) << name;
    EXPECT_TRUE(trial.isPassed()) << name;
  }
  EXPECT_TRUE(tryInverse(*kinematicModelFromUrdf(test::exactParallelAxesArm().urdf()), 300).isPassed());
}

// Of all classes, the drawn joints are among the solutions of a pose off singularities, and all solutions
// lead there within what rounding leaves.
TEST(InverseTrial, OffSingularitiesNoConfigurationIsMissed) {
  for (const std::string& urdf : {kinematicModelByName("irb_4600")->urdf(), test::roundedArm().urdf(),
                                  test::exactParallelAxesArm().urdf(), test::asideWristArm().urdf(),
                                  test::raisedWristArm().urdf(), test::sphericalSeven().urdf()}) {
    const auto arm = kinematicModelFromUrdf(urdf);
    const InverseTrial trial = tryInverse(*arm, 4000);
    EXPECT_EQ(trial.regular_recovered, trial.regular) << arm->name();
    EXPECT_GT(trial.regular, 3000U);
    EXPECT_LT(trial.regular, 4000U);
    EXPECT_LT(trial.tip_error_mm, 1e-6);
    EXPECT_LT(trial.turn_error_rad, 1e-9);
  }
}

TEST(InverseTrial, IsNotPassedWhereAPoseIsNotReachedOrReachHasNoEnd) {
  EXPECT_TRUE(trialOf(10, true).isPassed());
  EXPECT_FALSE(trialOf(9, true).isPassed());
  EXPECT_FALSE(trialOf(10, false).isPassed());
}

}  // namespace
}  // namespace lamina
