// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/joint_path/joint_unwinding.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

#include "lamina/base/random.hpp"

namespace lamina {
namespace {

constexpr double kJointUnwindingDegree = M_PI / 180.0;

std::vector<JointRange> oneJoint(double limit_deg) {
  return jointRanges(
      {{"c", JointKind::Rotary, -limit_deg * kJointUnwindingDegree, limit_deg * kJointUnwindingDegree, 1.0}});
}

/// A joint that turns on and on, in steps.
struct Turning {
  std::vector<JointValues> values;
  std::vector<WindLink> links;

  void add(double angle_deg, WindLink link) {
    JointValues value(1);
    value[0] = std::remainder(angle_deg, 360.0) * kJointUnwindingDegree;
    values.push_back(value);
    links.push_back(link);
  }
};

/// Whole turns in steps of 10 degrees; they may be rewound in between, at the ranks given.
Turning jointUnwindingTurning(int turns, const std::vector<double>& ranks = {}) {
  Turning jointUnwindingTurning;
  for (int step = 0; step <= 36 * turns; ++step) {
    WindLink link{step > 0, step > 0 && step % 36 == 0, 0.0};
    if (link.may_rewind && !ranks.empty()) link.rank = ranks[static_cast<std::size_t>(step / 36 - 1)];
    jointUnwindingTurning.add(10.0 * step, link);
  }
  return jointUnwindingTurning;
}

std::size_t rewindsOf(int turns, double limit_deg) {
  Turning way = jointUnwindingTurning(turns);
  const Unwound unwound = unwind(way.values, way.links, oneJoint(limit_deg));
  EXPECT_TRUE(unwound.wound_up.empty());
  return unwound.rewinds;
}

// Values at the places are multiples of 360 deg; n turns from one place until before another are -360 k to
// 360 (n - k) - 10, and the last of all values is 10 more.
TEST(JointUnwinding, IsRewoundAsOftenAsCountedByHand) {
  EXPECT_EQ(rewindsOf(6, 355.0), 6U);   // a turn at a time, and the last value by itself
  EXPECT_EQ(rewindsOf(6, 360.0), 2U);   // two turns at a time
  EXPECT_EQ(rewindsOf(6, 720.0), 1U);   // four
  EXPECT_EQ(rewindsOf(6, 1080.0), 0U);  // six
  EXPECT_EQ(rewindsOf(100, 1e6), 0U);
}

TEST(JointUnwinding, RewindsWhereTheRankIsHighestAmongTheFewest) {
  // Of 3 turns 2 fit, so one rewind is needed, at the first place or the second.
  Turning way = jointUnwindingTurning(3, {5.0, 1.0, 9.0});
  const Unwound unwound = unwind(way.values, way.links, oneJoint(370.0));
  ASSERT_EQ(unwound.rewinds, 1U);
  EXPECT_NEAR(unwound.values[35][0], 350.0 * kJointUnwindingDegree, 1e-9);
  EXPECT_NEAR(unwound.values[36][0], -360.0 * kJointUnwindingDegree, 1e-9);
}

TEST(JointUnwinding, NamesWhereARunIsTooLong) {
  Turning way = jointUnwindingTurning(2);
  for (WindLink& link : way.links) link.may_rewind = false;
  // It can start at 0 only; 190 deg is its limit.
  const Unwound unwound = unwind(way.values, way.links, oneJoint(190.0));
  ASSERT_FALSE(unwound.wound_up.empty());
  EXPECT_EQ(unwound.wound_up[0].index, 20U);
  EXPECT_EQ(unwound.wound_up[0].joint, 0U);
  EXPECT_NEAR(unwound.wound_up[0].lowest, 0.0, 1e-9);
  EXPECT_NEAR(unwound.wound_up[0].highest, 720.0 * kJointUnwindingDegree, 1e-9);
}

TEST(JointUnwinding, NamesWhatALoopPassesThatBeginsTooLate) {
  // From 40 to 400 deg, and on after a place to rewind: 200 deg is the limit.
  Turning way;
  for (int step = 0; step <= 40; ++step) way.add(40.0 + 10.0 * step, {step > 0, step == 37, 0.0});
  const Unwound unwound = unwind(way.values, way.links, oneJoint(200.0));
  ASSERT_EQ(unwound.wound_up.size(), 1U);
  EXPECT_EQ(unwound.wound_up[0].index, 17U);
  EXPECT_NEAR(unwound.wound_up[0].lowest, 40.0 * kJointUnwindingDegree, 1e-9);
  EXPECT_NEAR(unwound.wound_up[0].highest, 400.0 * kJointUnwindingDegree, 1e-9);
}

TEST(JointUnwinding, KeepsEveryValueWithinItsLimitsAndChangesItByWholeTurnsOnly) {
  EXPECT_TRUE(rc::check([](std::uint32_t seed) {
    Random random(seed);
    Turning way;
    double angle = 0.0;
    for (int i = 0; i < 200; ++i) {
      angle += random.uniform(-40.0, 60.0);
      way.add(angle, {i > 0, random.below(8) == 0, random.uniform(0.0, 9.0)});
    }
    const double limit = random.uniform(200.0, 800.0);
    const Unwound unwound = unwind(way.values, way.links, oneJoint(limit));
    std::size_t rewinds = 0;
    for (std::size_t i = 0; i < unwound.values.size(); ++i) {
      RC_ASSERT(std::abs(unwound.values[i][0]) <= limit * kJointUnwindingDegree + 1e-6);
      RC_ASSERT(std::abs(std::remainder(unwound.values[i][0] - way.values[i][0], 2.0 * M_PI)) < 1e-9);
      if (i > 0 && std::abs(unwound.values[i][0] - unwound.values[i - 1][0]) > M_PI) ++rewinds;
    }
    RC_ASSERT(rewinds >= unwound.rewinds);
    RC_ASSERT(rewinds <= unwound.rewinds + unwound.wound_up.size());
  }));
}

}  // namespace
}  // namespace lamina
