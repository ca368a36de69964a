// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tf/transform_sequence.hpp"

#include <gtest/gtest.h>

#include "names.hpp"
#include "ros/monitor/plate_scan.hpp"
#include "ros/set_time.hpp"

namespace lamina {
namespace {

constexpr char kAuthority[] = "test";

/// The nozzle at height z [mm] at a stamp [s].
geometry_msgs::TransformStamped nozzleAt(double stamp_s, double z) {
  return test::stamped(test::bedFromNozzle({0, 0, z}), names::kBedFrame, names::kNozzleFrame,
                       ros::Time(stamp_s));
}

/// With the sensor on the nozzle, which rises by 1 mm a second.
void addRise(TransformSequence& sequence, int from_s, int to_s) {
  for (int i = from_s; i < to_s; ++i) sequence.add(nozzleAt(i, i), kAuthority);
}

TransformSequence& withSensor(TransformSequence& sequence) {
  sequence.addFixed(
      test::stamped(test::nozzleFromSensor(), names::kNozzleFrame, names::kSensorFrame, ros::Time(1)),
      kAuthority);
  return sequence;
}

TEST(TransformSequence, GivesNoMoreThanIsAskedFor) {
  TransformSequence sequence;
  withSensor(sequence);
  addRise(sequence, 1000, 5000);
  EXPECT_EQ(sequence.passTo(names::kSensorFrame, ros::Time(1002.5)), Readiness::Ready);
  const auto latest = sequence.buffer().lookupTransform(names::kBedFrame, names::kNozzleFrame, ros::Time(0));
  EXPECT_EQ(latest.header.stamp, ros::Time(1003));
  // However far tf is ahead, what comes next is still known.
  EXPECT_EQ(sequence.passTo(names::kSensorFrame, ros::Time(1003)), Readiness::Ready);
  EXPECT_EQ(sequence.received(), 4001U);
}

TEST(TransformSequence, ReportsTheNozzleAtEveryStampOnce) {
  TransformSequence sequence;
  withSensor(sequence);
  addRise(sequence, 1000, 1010);
  EXPECT_TRUE(sequence.takeNozzles().empty());
  sequence.passTo(names::kSensorFrame, ros::Time(1003.5));
  const auto nozzles = sequence.takeNozzles();
  ASSERT_EQ(nozzles.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(nozzles[i].stamp, ros::Time(1000.0 + double(i)));
    EXPECT_NEAR(nozzles[i].bed_from_nozzle.translation().z(), 1000.0 + double(i), 1e-9);
  }
  EXPECT_TRUE(sequence.takeNozzles().empty());
  while (sequence.passNext()) {
  }
  EXPECT_EQ(sequence.takeNozzles().size(), 5U);
}

TEST(TransformSequence, WaitsForTransformsThatAreStillToCome) {
  TransformSequence sequence;
  withSensor(sequence);
  EXPECT_EQ(sequence.passTo(names::kSensorFrame, ros::Time(1001)), Readiness::NotYet);
  addRise(sequence, 1000, 1001);
  EXPECT_EQ(sequence.passTo(names::kSensorFrame, ros::Time(1001)), Readiness::NotYet);
  addRise(sequence, 1001, 1002);
  EXPECT_EQ(sequence.passTo(names::kSensorFrame, ros::Time(1001)), Readiness::Ready);
}

TEST(TransformSequence, WhatIsOlderThanTheFirstTransformIsNeverKnown) {
  TransformSequence sequence;
  withSensor(sequence);
  addRise(sequence, 1000, 1010);
  EXPECT_EQ(sequence.passTo(names::kSensorFrame, ros::Time(999)), Readiness::Never);
}

TEST(TransformSequence, AFrameThatNobodyNamesIsNotLookedForToTheEnd) {
  TransformSequence sequence;
  withSensor(sequence);
  addRise(sequence, 1000, 5000);
  EXPECT_FALSE(sequence.knows("nowhere"));
  EXPECT_EQ(sequence.passTo("nowhere", ros::Time(1001)), Readiness::NotYet);
  EXPECT_EQ(sequence.passTo(names::kSensorFrame, ros::Time(1002)), Readiness::Ready);
}

/// As drivers from before tf2 write them: buffers of tf2 take such a name for that of no frame at all.
TEST(TransformSequence, AFrameMayBeNamedWithALeadingSlash) {
  TransformSequence sequence;
  withSensor(sequence);
  addRise(sequence, 1000, 1010);
  EXPECT_EQ(sequence.passTo("/sensor", ros::Time(1002.5)), Readiness::Ready);
  const auto by_slash = lookUp(sequence.buffer(), names::kBedFrame, "/sensor", ros::Time(1002.5));
  const auto by_name = lookUp(sequence.buffer(), names::kBedFrame, names::kSensorFrame, ros::Time(1002.5));
  ASSERT_TRUE(by_slash && by_name);
  EXPECT_TRUE(by_slash->isApprox(*by_name));
  EXPECT_EQ(sequence.passTo("/sensor", ros::Time(999)), Readiness::Never);
}

TEST(TransformSequence, TransformsOfOneStampGoTogetherAndInTheOrderOfStamps) {
  TransformSequence sequence;
  for (const int second : {1002, 1000, 1001}) {
    sequence.add(test::stamped(Eigen::Isometry3d::Identity(), "world", names::kBedFrame, ros::Time(second)),
                 kAuthority);
    sequence.add(test::stamped(test::bedFromNozzle({0, 0, double(second)}), "world", names::kNozzleFrame,
                               ros::Time(second)),
                 kAuthority);
  }
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(sequence.passNext());
    const auto nozzles = sequence.takeNozzles();
    ASSERT_EQ(nozzles.size(), 1U);
    EXPECT_NEAR(nozzles[0].bed_from_nozzle.translation().z(), 1000.0 + i, 1e-9);
  }
  EXPECT_FALSE(sequence.passNext());
}

TEST(TransformSequence, WithTooManyWaitingNoPoseOfTheNozzleIsLost) {
  TransformSequence sequence(10);
  withSensor(sequence);
  addRise(sequence, 1000, 1025);
  EXPECT_EQ(sequence.forced(), 15U);
  while (sequence.passNext()) {
  }
  EXPECT_EQ(sequence.takeNozzles().size(), 25U);
  EXPECT_EQ(sequence.forced(), 15U);
}

TEST(TransformSequence, RemembersNoStampThatTheBufferHasForgotten) {
  TransformSequence sequence(10);
  const auto add = [&sequence](int second) {
    sequence.add(test::stamped(Eigen::Isometry3d::Identity(), "world", names::kBedFrame, ros::Time(second)),
                 kAuthority);
  };
  // No nozzle is reported, so that the pose of none can be taken.
  for (int i = 1000; i < 11000; ++i) add(i);
  EXPECT_LE(sequence.untaken(), 40U);
  while (sequence.passNext()) {
  }
  EXPECT_LE(sequence.untaken(), 40U);
  EXPECT_TRUE(sequence.takeNozzles().empty());
}

TEST(TransformSequence, AStampFarAheadLosesNoPoseOfTheNozzle) {
  TransformSequence sequence;
  addRise(sequence, 1000, 1010);
  while (sequence.passNext()) {
  }
  sequence.add(test::stamped(Eigen::Isometry3d::Identity(), "world", "elsewhere", ros::Time(100000)),
               kAuthority);
  addRise(sequence, 1010, 1020);
  while (sequence.passNext()) {
  }
  EXPECT_EQ(sequence.takeNozzles().size(), 20U);
}

std::vector<StampedNozzle> allNozzles(TransformSequence& sequence) {
  std::vector<StampedNozzle> nozzles;
  do {
    for (const StampedNozzle& nozzle : sequence.takeNozzles()) nozzles.push_back(nozzle);
  } while (sequence.passNext());
  return nozzles;
}

/// Of a clock that is set, or of a message that is garbled.
TEST(TransformSequence, LeavesOutAPoseOfTheNozzleWhoseStampAloneIsFarAhead) {
  TransformSequence sequence;
  withSensor(sequence);
  addRise(sequence, 1000, 1010);
  EXPECT_EQ(allNozzles(sequence).size(), 10U);
  sequence.add(nozzleAt(100000, 5), kAuthority);
  EXPECT_TRUE(allNozzles(sequence).empty());
  addRise(sequence, 1010, 1020);
  const auto nozzles = allNozzles(sequence);
  ASSERT_EQ(nozzles.size(), 10U);
  EXPECT_EQ(nozzles.front().stamp, ros::Time(1010));
  EXPECT_EQ(nozzles.back().stamp, ros::Time(1019));
  EXPECT_EQ(sequence.passTo(names::kSensorFrame, ros::Time(1015.5)), Readiness::Ready);
}

TEST(TransformSequence, GoesOnBehindAPauseThatIsLongerThanItRemembers) {
  TransformSequence sequence;
  addRise(sequence, 1000, 1010);
  EXPECT_EQ(allNozzles(sequence).size(), 10U);
  addRise(sequence, 1100, 1110);
  const auto nozzles = allNozzles(sequence);
  ASSERT_EQ(nozzles.size(), 10U);
  EXPECT_EQ(nozzles.front().stamp, ros::Time(1100));
  // Of one that comes every minute, each is believed by the next.
  for (int i = 1200; i <= 1440; i += 60) addRise(sequence, i, i + 1);
  EXPECT_EQ(allNozzles(sequence).size(), 4U);
}

TEST(TransformSequence, BelievesTheLowerOfTwoStampsFarAhead) {
  TransformSequence sequence;
  addRise(sequence, 1000, 1010);
  EXPECT_EQ(allNozzles(sequence).size(), 10U);
  sequence.add(nozzleAt(100000, 5), kAuthority);
  addRise(sequence, 1100, 1110);
  const auto nozzles = allNozzles(sequence);
  ASSERT_EQ(nozzles.size(), 10U);
  EXPECT_EQ(nozzles.back().stamp, ros::Time(1109));
}

TEST(TransformSequence, WithTooManyWaitingTheOldestGoUnasked) {
  TransformSequence sequence(100);
  withSensor(sequence);
  addRise(sequence, 1000, 1200);
  EXPECT_EQ(sequence.forced(), 100U);
  const auto latest = sequence.buffer().lookupTransform(names::kBedFrame, names::kNozzleFrame, ros::Time(0));
  EXPECT_EQ(latest.header.stamp, ros::Time(1099));
  EXPECT_EQ(sequence.passTo(names::kSensorFrame, ros::Time(1050)), Readiness::Never);
  EXPECT_EQ(sequence.passTo(names::kSensorFrame, ros::Time(1150)), Readiness::Ready);
}

TEST(TransformSequence, BeginsAnewWhenRosTimeGoesBack) {
  const test::SetTime time;
  TransformSequence sequence;
  withSensor(sequence);
  for (int i = 1000; i < 1010; ++i) {
    time.set(i);
    sequence.add(nozzleAt(i, i), kAuthority);
  }
  EXPECT_EQ(sequence.passTo(names::kSensorFrame, ros::Time(1005)), Readiness::Ready);
  EXPECT_FALSE(sequence.takeNozzles().empty());
  EXPECT_EQ(sequence.restarts(), 0U);
  time.set(500.0);
  sequence.add(nozzleAt(1010, 1010), kAuthority);  // that was under way
  for (int i = 501; i < 510; ++i) {
    time.set(i);
    sequence.add(nozzleAt(i, i), kAuthority);
  }
  EXPECT_EQ(sequence.restarts(), 1U);
  EXPECT_EQ(sequence.passTo(names::kSensorFrame, ros::Time(505.5)), Readiness::Ready);
  const auto nozzles = sequence.takeNozzles();
  ASSERT_EQ(nozzles.size(), 6U);
  EXPECT_EQ(nozzles.front().stamp, ros::Time(501.0));
  EXPECT_NEAR(nozzles.back().bed_from_nozzle.translation().z(), 506.0, 1e-9);
  EXPECT_EQ(sequence.passTo(names::kSensorFrame, ros::Time(1005)), Readiness::NotYet);
}

TEST(TransformSequence, GoesOnWhenRosTimeGoesBackALittle) {
  const test::SetTime time;
  TransformSequence sequence;
  withSensor(sequence);
  time.set(1000.0);
  sequence.add(nozzleAt(1000.0, 1.0), kAuthority);
  time.set(999.9);
  sequence.add(nozzleAt(1000.1, 2.0), kAuthority);
  EXPECT_EQ(sequence.restarts(), 0U);
  EXPECT_EQ(sequence.received(), 3U);
  EXPECT_EQ(sequence.passTo(names::kSensorFrame, ros::Time(1000.0)), Readiness::Ready);
}

}  // namespace
}  // namespace lamina
