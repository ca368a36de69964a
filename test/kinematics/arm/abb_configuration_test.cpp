// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/kinematics/arm/abb_configuration.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "lamina/base/error.hpp"

namespace lamina {
namespace {

std::array<int, 4> configuration(const KinematicModel& arm, const std::array<double, 6>& degrees) {
  JointValues values(6);
  for (Eigen::Index j = 0; j < 6; ++j) values[j] = degrees[static_cast<std::size_t>(j)] * M_PI / 180.0;
  const AbbConfiguration found = abbConfiguration(arm, values);
  return {found.cf1, found.cf4, found.cf6, found.cfx};
}

using Four = std::array<int, 4>;

TEST(AbbConfiguration, QuadrantsCountQuarterTurnsEitherWay) {
  const auto arm = kinematicModelByName("irb_4600");
  EXPECT_EQ(configuration(*arm, {10, 0, 0, 100, 30, 200}), (Four{0, 1, 2, 0}));
  EXPECT_EQ(configuration(*arm, {-10, 0, 0, -100, 30, -200}), (Four{-1, -2, -3, 0}));
  EXPECT_EQ(configuration(*arm, {-170, 0, 0, 280, 30, 370}), (Four{-2, 3, 4, 0}));
}

TEST(AbbConfiguration, AQuadrantBeginsAtItsQuarterTurn) {
  const auto arm = kinematicModelByName("irb_4600");
  EXPECT_EQ(configuration(*arm, {0, 0, 0, 90, 30, -90}), (Four{0, 1, -1, 0}));
  EXPECT_EQ(configuration(*arm, {-1e-12, 0, 0, 90 - 1e-12, 30, 180}), (Four{0, 1, 2, 0}));
  EXPECT_EQ(configuration(*arm, {-1e-6, 0, 0, 90 - 1e-6, 30, 180}), (Four{-1, 0, 2, 0}));
}

TEST(AbbConfiguration, CfxReportsWristAndAxis5) {
  const auto arm = kinematicModelByName("irb_4600");
  EXPECT_EQ(configuration(*arm, {0, 0, 0, 0, 30, 0})[3], 0);
  EXPECT_EQ(configuration(*arm, {0, 0, 0, 0, -30, 0})[3], 1);
  // Upper arm level to the front, forearm bent back over it: behind the lower arm, before axis 1.
  EXPECT_EQ(configuration(*arm, {0, 80, -160, 0, 30, 0})[3], 2);
  EXPECT_EQ(configuration(*arm, {0, 80, -160, 0, -30, 0})[3], 3);
  // Upper arm leaning back by 80 deg, forearm up and on to the back: behind axis 1.
  EXPECT_EQ(configuration(*arm, {0, -80, 0, 0, 30, 0})[3], 4);
  EXPECT_EQ(configuration(*arm, {0, -80, 0, 0, -30, 0})[3], 5);
  EXPECT_EQ(configuration(*arm, {0, -60, -100, 0, 30, 0})[3], 6);
  EXPECT_EQ(configuration(*arm, {0, -60, -100, 0, -30, 0})[3], 7);
}

TEST(AbbConfiguration, AllSolutionsOfAPoseDiffer) {
  const auto arm = kinematicModelByName("irb_4600");
  JointValues values(6);
  values << 0.3, -0.4, -0.2, 0.5, 0.6, 0.7;
  std::set<int> all;
  for (const InverseSolution& solution : arm->solutions(arm->bedFromNozzle(values), values)) {
    const int cfx = abbConfiguration(*arm, solution.values).cfx;
    EXPECT_EQ(cfx, solution.branch);
    all.insert(cfx);
  }
  EXPECT_EQ(all.size(), 8U);
}

TEST(AbbConfiguration, AMachineThatIsNoArmIsRefused) {
  const auto machine = kinematicModelByName("cartesian_gantry");
  EXPECT_THROW(abbConfiguration(*machine, JointValues::Zero(3)), InvalidConfig);
}

}  // namespace
}  // namespace lamina
