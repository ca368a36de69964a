// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/pose_watches.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

constexpr std::int64_t kTenthNs = 100'000'000;
constexpr std::int64_t kTip = 1000 * kTenthNs;  // stamp of the last pose

TEST(PoseWatches, TellForHowLongNoPoseHasComeAndThatOneHas) {
  PoseWatches watches(2.0);
  EXPECT_EQ(watches.blind(kTip), 0.0);
  watches.hear("left", kTip + 25 * kTenthNs, kTip);
  EXPECT_NEAR(watches.blind(kTip), 2.5, 1e-9);
  EXPECT_FALSE(watches.isWithoutPose(kTip));
  EXPECT_NEAR(watches.blind(kTip + 20 * kTenthNs), 0.5, 1e-9) << "by a pose that came since";
  EXPECT_TRUE(watches.isHeard(kTip + 44 * kTenthNs));
  EXPECT_FALSE(watches.isHeard(kTip + 46 * kTenthNs));
  watches.begin();
  EXPECT_EQ(watches.blind(kTip), 0.0);
  EXPECT_FALSE(watches.isHeard(kTip));
}

TEST(PoseWatches, TellForHowLongCloudsComeWithoutAnyPose) {
  PoseWatches watches(2.0);
  watches.hear("left", kTip, {});
  watches.hear("left", kTip + 30 * kTenthNs, {});
  EXPECT_TRUE(watches.isWithoutPose({}));
  EXPECT_NEAR(watches.blind({}), 3.0, 1e-9);
  EXPECT_FALSE(watches.isWithoutPose(kTip + 30 * kTenthNs)) << "the first one came";
  EXPECT_NEAR(watches.blind(kTip + 30 * kTenthNs), 0.0, 1e-9);
  EXPECT_LT(watches.blind(kTip + 900 * kTenthNs), 0.0) << "and others long after the last cloud";
}

/// One sensor has poses, another has a clock that is a minute ahead or behind, and sends ten times as often.
TEST(PoseWatches, HearASensorBesideOneWhoseClockIsWrong) {
  for (const std::int64_t off : {600 * kTenthNs, -600 * kTenthNs}) {
    PoseWatches watches(2.0);
    for (int i = 0; i <= 400; ++i) {
      const std::int64_t tip = kTip + i * kTenthNs / 10;
      if (i % 10 == 0) watches.hear("right", tip, tip);
      watches.hear("left", tip + off, tip);
      EXPECT_LE(watches.blind(tip), 0.0) << i;
      EXPECT_FALSE(watches.isWithoutPose(tip)) << i;
    }
    const std::int64_t end = kTip + 40 * kTenthNs;
    for (int i = 1; i <= 19; ++i) watches.hear("left", end + off + i * kTenthNs, end + i * kTenthNs);
    EXPECT_LE(watches.blind(end + 19 * kTenthNs), 0.0);
    for (int i = 20; i <= 60; ++i) watches.hear("left", end + off + i * kTenthNs, end + i * kTenthNs);
    EXPECT_GT(watches.blind(end + 60 * kTenthNs), 2.0) << "the other one is silent";
  }
}

}  // namespace
}  // namespace lamina
