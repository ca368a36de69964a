// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stamps.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace lamina {
namespace {

const ros::Time kToday(1700000000, 250000000);
const ros::Time kGarbled(std::numeric_limits<std::uint32_t>::max(), 0);

TEST(Stamps, AreAsFarApartAsTheyAreHoweverFar) {
  EXPECT_DOUBLE_EQ(secondsBetween(kToday, ros::Time(1700000001, 0)), 0.75);
  EXPECT_DOUBLE_EQ(secondsBetween(ros::Time(1700000001, 0), kToday), -0.75);
  EXPECT_DOUBLE_EQ(secondsBetween(kToday, ros::Time()), -1700000000.25);
  EXPECT_DOUBLE_EQ(secondsBetween(kToday, kGarbled), 2594967294.75);
  EXPECT_DOUBLE_EQ(secondsBetween(kGarbled, ros::Time()), -4294967295.0);
}

TEST(Stamps, EndWhereThereAreNoMore) {
  EXPECT_EQ(stampAfter(kToday, ros::Duration(1.5)), ros::Time(1700000001, 750000000));
  EXPECT_EQ(stampAfter(ros::Time(5, 0), ros::Duration(-1.5)), ros::Time(3, 500000000));
  EXPECT_LE(stampAfter(ros::Time(1, 0), ros::Duration(-10.0)).toSec(), 1e-6);
  EXPECT_EQ(stampAfter(kGarbled, ros::Duration(10.0)), ros::TIME_MAX);
}

}  // namespace
}  // namespace lamina
