// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/description_files/inverse_trial.hpp"

#include <gtest/gtest.h>

#include "support/arms.hpp"

namespace lamina {
namespace {

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

TEST(InverseTrial, IsNotPassedWhereAPoseIsNotReachedOrReachHasNoEnd) {
  EXPECT_TRUE((InverseTrial{10, 10, 9, true}.isPassed()));
  EXPECT_FALSE((InverseTrial{10, 9, 9, true}.isPassed()));
  EXPECT_FALSE((InverseTrial{10, 10, 10, false}.isPassed()));
}

}  // namespace
}  // namespace lamina
