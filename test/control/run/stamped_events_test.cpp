// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/run/stamped_events.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

SensedCloud cloud(std::int64_t stamp_ns, double x) {
  SensedCloud cloud;
  cloud.stamp_ns = stamp_ns;
  cloud.profiles = {{Point3(x, 0.0, 0.0)}};
  return cloud;
}

TEST(StampedEvents, AreTakenByStampThenPosesThenContent) {
  StampedEvents events;
  EXPECT_FALSE(events.latest());
  events.add(cloud(20, 2.0));
  events.add(cloud(20, 1.0));
  EXPECT_FALSE(events.latestTip());
  events.add({20, Point3(5.0, 0.0, 0.0)});
  events.add({10, Point3(7.0, 0.0, 0.0)});
  EXPECT_EQ(events.latest(), 20);
  EXPECT_EQ(events.latestTip(), 20);
  EXPECT_FALSE(events.takeUntil(9));
  EXPECT_EQ(events.takeUntil(20)->tip.x(), 7.0);
  EXPECT_EQ(events.takeUntil(20)->tip.x(), 5.0);
  EXPECT_EQ(events.takeUntil(20)->cloud->profiles[0][0].x(), 1.0);
  EXPECT_EQ(events.takeUntil(20)->cloud->profiles[0][0].x(), 2.0);
  EXPECT_FALSE(events.takeUntil(20));
}

TEST(StampedEvents, AreLateAfterALaterOneWasTaken) {
  StampedEvents events;
  events.add({10, Point3::Zero()});
  events.add({30, Point3::Zero()});
  EXPECT_FALSE(events.isLate(5));
  EXPECT_TRUE(events.takeUntil(10));
  EXPECT_TRUE(events.isLate(9));
  EXPECT_FALSE(events.isLate(10));
  events.clear();
  EXPECT_FALSE(events.takeUntil(30));
  EXPECT_FALSE(events.isLate(20)) << "it was not taken";
}

}  // namespace
}  // namespace lamina
