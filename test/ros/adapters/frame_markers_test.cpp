// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "markers/frame_markers.hpp"

#include <gtest/gtest.h>

namespace {

using visualization_msgs::Marker;

/// A bead of 10 mm along x in three waypoints, the nozzle straight down.
lamina::Toolpath line() {
  lamina::Path path;
  path.points = {{0, 0, 1}, {4, 0, 1}, {10, 0, 1}};
  path.bead = lamina::Bead{0.4, 0.2};
  path.feed_mm_s = 10.0;
  lamina::Toolpath toolpath;
  toolpath.layers.push_back({1.0, 1.0, {path}});
  return toolpath;
}

TEST(FrameMarkers, AreNotShownUnlessAskedFor) {
  const auto markers = lamina::frameMarkers(line(), {}, "part").markers;
  ASSERT_EQ(markers.size(), 1U);
  EXPECT_EQ(markers[0].action, Marker::DELETEALL + 0);
}

TEST(FrameMarkers, DrawXBlueYRedAndTheToolAxisGreen) {
  lamina::FrameSettings settings;
  settings.every_mm = 5.0;
  settings.length_mm = 3.0;
  const auto markers = lamina::frameMarkers(line(), settings, "part").markers;
  ASSERT_EQ(markers.size(), 4U);
  // At the first waypoint and 10 mm on; 4 mm are too near.
  for (std::size_t axis = 1; axis < 4; ++axis) EXPECT_EQ(markers[axis].points.size(), 4U);
  for (std::size_t axis = 1; axis < 4; ++axis) EXPECT_TRUE(markers[axis].frame_locked) << axis;
  EXPECT_GT(markers[1].color.b, 0.8F);
  EXPECT_DOUBLE_EQ(markers[1].points.at(1).x, 0.003);
  EXPECT_GT(markers[2].color.r, 0.8F);
  EXPECT_DOUBLE_EQ(markers[2].points.at(1).y, -0.003);
  EXPECT_GT(markers[3].color.g, 0.6F);
  EXPECT_DOUBLE_EQ(markers[3].points.at(1).z, -0.002);
  EXPECT_DOUBLE_EQ(markers[3].points.at(2).x, 0.010);
}

}  // namespace
