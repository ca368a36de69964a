// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/layer_height_monitor/cloud_stamps.hpp"

#include <gtest/gtest.h>

namespace lamina {
namespace {

TEST(CloudStamps, ReachTheStampOfTheLastCloud) {
  CloudStamps stamps;
  EXPECT_TRUE(stamps.haveReached(ros::Time())) << "no more than has come";
  EXPECT_FALSE(stamps.haveReached(ros::Time(5.0)));
  stamps.add(ros::Time(4.9));
  EXPECT_FALSE(stamps.haveReached(ros::Time(5.0)));
  stamps.add(ros::Time(5.0));
  EXPECT_TRUE(stamps.haveReached(ros::Time(5.0)));
  stamps.add(ros::Time());
  stamps.add(ros::Time(4.95));
  EXPECT_TRUE(stamps.haveReached(ros::Time(5.0))) << "another sensor's comes later";
}

TEST(CloudStamps, AreNotReachedByASingleOneFarAhead) {
  CloudStamps stamps;
  stamps.add(ros::Time(1.0));
  stamps.add(ros::Time(4e9));
  EXPECT_FALSE(stamps.haveReached(ros::Time(5.0)));
  for (int i = 11; i < 49; ++i) stamps.add(ros::Time(0.1 * i));
  EXPECT_FALSE(stamps.haveReached(ros::Time(5.0)));
  stamps.add(ros::Time(5.1));
  EXPECT_FALSE(stamps.haveReached(ros::Time(5.0))) << "nobody knows yet which of them is right";
  stamps.add(ros::Time(5.2));
  EXPECT_TRUE(stamps.haveReached(ros::Time(5.0)));
}

}  // namespace
}  // namespace lamina
