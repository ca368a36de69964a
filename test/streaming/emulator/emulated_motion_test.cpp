// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/streaming/emulator/emulated_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lamina {
namespace {

constexpr double kSame = 1e-9;

class EmulatedMotionTest : public testing::Test {
 protected:
  static MotionLimits limits() {
    MotionLimits limits;
    limits.acceleration_mm_s2 = 1000.0;
    limits.travel_acceleration_mm_s2 = 1000.0;
    return limits;
  }
  void run() {
    while (const auto event = motion_.nextEvent()) motion_.advance(*event);
  }

  std::vector<ExecutedMotion> executed_;
  EmulatedMotion motion_{limits(), 4, [this](const ExecutedMotion& motion) { executed_.push_back(motion); }};
};

TEST_F(EmulatedMotionTest, RunsALoneMotionAsATrapezoid) {
  motion_.add({{0, 0, 0}, {100, 0, 0}, 5.0, 100.0}, 0.0);
  run();
  ASSERT_EQ(executed_.size(), 1U);
  // 0.1 s and 5 mm to speed up and as much to slow down, 90 mm at 100 mm/s in between.
  EXPECT_NEAR(executed_[0].end_s - executed_[0].start_s, 1.1, kSame);
  EXPECT_NEAR(executed_[0].positionAt(executed_[0].start_s + 0.1).x(), 5.0, kSame);
  EXPECT_NEAR(executed_[0].positionAt(executed_[0].start_s + 0.55).x(), 50.0, kSame);
  EXPECT_NEAR(motion_.filament(), 5.0, kSame);
  EXPECT_EQ(motion_.starvations(), 1U);
}

TEST_F(EmulatedMotionTest, ReportsWhenTheNozzleIsWhere) {
  motion_.add({{0, 0, 0}, {0, 40, 30}, 1.0, 80.0}, 0.0);
  run();
  for (const double part : {0.0, 0.01, 0.06, 0.3, 0.5, 0.94, 0.99, 1.0}) {
    EXPECT_NEAR(executed_[0].positionAt(executed_[0].timeAt(part)).y(), 40.0 * part, 1e-6) << part;
  }
}

TEST_F(EmulatedMotionTest, KeepsSpeedThroughStraightJunctions) {
  motion_.add({{0, 0, 0}, {50, 0, 0}, 1.0, 100.0}, 0.0);
  motion_.add({{50, 0, 0}, {100, 0, 0}, 1.0, 100.0}, 0.0);
  run();
  ASSERT_EQ(executed_.size(), 2U);
  EXPECT_NEAR(executed_[1].end_s - executed_[0].start_s, 1.1, kSame);
  EXPECT_NEAR(executed_[0].profile.exit_mm_s, 100.0, kSame);
  EXPECT_DOUBLE_EQ(executed_[0].end_s, executed_[1].start_s);
}

TEST_F(EmulatedMotionTest, StopsWhereItTurnsBack) {
  motion_.add({{0, 0, 0}, {50, 0, 0}, 1.0, 100.0}, 0.0);
  motion_.add({{50, 0, 0}, {0, 0, 0}, 1.0, 100.0}, 0.0);
  run();
  EXPECT_NEAR(executed_[0].profile.exit_mm_s, 0.0, kSame);
  EXPECT_NEAR(executed_[1].end_s - executed_[0].start_s, 1.2, kSame);
}

TEST_F(EmulatedMotionTest, CanAlwaysStopAtTheEndOfItsQueue) {
  for (int i = 0; i < 4; ++i) motion_.add({Point3(i, 0, 0), Point3(i + 1, 0, 0), 0.1, 500.0}, 0.0);
  EXPECT_TRUE(motion_.isFull());
  run();
  // Over 4 mm: up to sqrt(2 * 1000 * 2) mm/s in the middle, and down again.
  EXPECT_NEAR(executed_[1].profile.exit_mm_s, std::sqrt(4000.0), 1e-6);
  EXPECT_NEAR(executed_[3].profile.exit_mm_s, 0.0, kSame);
}

TEST_F(EmulatedMotionTest, BeginsAtOnceWhenTheQueueIsFull) {
  motion_.add({{0, 0, 0}, {1, 0, 0}, 0.1, 50.0}, 2.0);
  EXPECT_GT(motion_.nextEvent().value(), 2.0);
  for (int i = 1; i < 4; ++i) motion_.add({Point3(i, 0, 0), Point3(i + 1, 0, 0), 0.1, 50.0}, 2.0);
  EXPECT_DOUBLE_EQ(motion_.nextEvent().value(), 2.0);
}

TEST_F(EmulatedMotionTest, StopsQuicklyWhereItIs) {
  motion_.add({{0, 0, 0}, {100, 0, 0}, 10.0, 100.0}, 0.0);
  motion_.add({{100, 0, 0}, {100, 100, 0}, 10.0, 100.0}, 0.0);
  const double begin = motion_.nextEvent().value();
  motion_.advance(begin);
  motion_.quickStop(begin + 0.55);
  EXPECT_TRUE(motion_.isEmpty());
  ASSERT_EQ(executed_.size(), 1U);
  EXPECT_NEAR(executed_[0].end.x(), 50.0, kSame);
  EXPECT_NEAR(executed_[0].filament_mm, 5.0, kSame);
  EXPECT_NEAR(motion_.positionAt(begin + 1.0).x(), 50.0, kSame);
  EXPECT_NEAR(executed_[0].positionAt(begin + 0.1).x(), 5.0, kSame);
}

TEST_F(EmulatedMotionTest, RunsRetractionsInPlace) {
  motion_.add({{1, 2, 3}, {1, 2, 3}, -2.0, 40.0}, 0.0);
  run();
  ASSERT_EQ(executed_.size(), 1U);
  EXPECT_EQ(executed_[0].end, Point3(1, 2, 3));
  EXPECT_DOUBLE_EQ(motion_.filament(), -2.0);
  EXPECT_NEAR(executed_[0].end_s - executed_[0].start_s, 2.0 / 40.0 + 0.04, kSame);
}

TEST_F(EmulatedMotionTest, IgnoresMotionsThatDoNothing) {
  motion_.add({{1, 2, 3}, {1, 2, 3}, 0.0, 40.0}, 0.0);
  EXPECT_TRUE(motion_.isEmpty());
}

}  // namespace
}  // namespace lamina
