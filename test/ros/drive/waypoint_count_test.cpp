// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "nodes/trajectory_driver/file/waypoint_count.hpp"

#include <gtest/gtest.h>

#include "support/toolpaths.hpp"

namespace lamina {
namespace {

// Of the table of `twoLayers`: five rows of the closed square, two of the travel, two of the line.
TEST(WaypointCount, CountsTheRowsOfTheFile) {
  WaypointCount count(test::twoLayers());
  EXPECT_EQ(count.total(), 9U);
  EXPECT_EQ(count.reached(), 0U);
  count.see({0, 0, 1}, {0, 0, 3});
  EXPECT_EQ(count.reached(), 1U);
  EXPECT_EQ(count.handedOver(), 4U);
  count.see({0, 0, 3}, {0, 0, 0});
  EXPECT_EQ(count.reached(), 3U);
  EXPECT_EQ(count.handedOver(), 4U) << "what is handed over stays";
  count.see({0, 0, 0}, {0, 0, 0});
  EXPECT_EQ(count.reached(), 3U) << "the square closes at its first corner";
  count.see({0, 1, 1}, {1, 0, 1});
  EXPECT_EQ(count.reached(), 6U);
  EXPECT_EQ(count.handedOver(), 9U);
  count.see({0, 0, 1}, {0, 0, 1});
  EXPECT_EQ(count.reached(), 6U) << "nothing is taken back";
  count.complete();
  EXPECT_EQ(count.reached(), 9U);
}

TEST(WaypointCount, KnowsNothingOfPlacesThatTheFileDoesNotHave) {
  WaypointCount count(test::twoLayers());
  count.see({7, 0, 0}, {0, 9, 0});
  EXPECT_EQ(count.reached(), 0U);
  EXPECT_EQ(WaypointCount(Toolpath()).total(), 0U);
}

}  // namespace
}  // namespace lamina
