// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/verification/collision/checked_machine.hpp"

#include <gtest/gtest.h>

#include "lamina/base/random.hpp"
#include "lamina/verification/collision/checked_bodies.hpp"
#include "lamina/verification/collision/self_collision_guard.hpp"

namespace lamina {
namespace {

TEST(CheckedMachine, MakesBodiesAndGuardOnce) {
  const auto arm = kinematicModelByName("irb_4600");
  const CheckedMachine machine(*arm);
  EXPECT_EQ(&machine.model(), arm.get());
  EXPECT_EQ(&machine.bodies(), &machine.bodies());
  EXPECT_EQ(&machine.guard(), &machine.guard());
  EXPECT_EQ(machine.bodies().pairs, checkedBodies(*arm).pairs);
}

TEST(CheckedMachine, ItsGuardForbidsWhatTheGuardOfTheArmForbids) {
  const auto arm = kinematicModelByName("irb_4600");
  const CheckedMachine machine(*arm);
  const SelfCollisionGuard guard(*arm, checkedBodies(*arm));
  Random random(2);
  int forbidden = 0;
  for (int i = 0; i < 2000; ++i) {
    JointValues values(6);
    for (Eigen::Index j = 0; j < 6; ++j) {
      const DrivenJoint& joint = arm->joints()[static_cast<std::size_t>(j)];
      values[j] = random.uniform(joint.low, joint.high);
    }
    EXPECT_EQ(machine.guard().allows(values), guard.allows(values));
    EXPECT_EQ(machine.guard().hindrance(values), guard.hindrance(values));
    forbidden += guard.allows(values) ? 0 : 1;
  }
  EXPECT_GT(forbidden, 20);
  EXPECT_LT(forbidden, 1980);
}

}  // namespace
}  // namespace lamina
