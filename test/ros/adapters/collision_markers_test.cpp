// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "markers/collision_markers.hpp"

#include <gtest/gtest.h>

namespace {

using lamina::ClearanceReport;
using lamina::Collision;
using visualization_msgs::Marker;

TEST(CollisionMarkers, OfNothingDeleteTheOldOnes) {
  const auto markers = lamina::collisionMarkers(ClearanceReport(), "bed").markers;
  ASSERT_EQ(markers.size(), 1U);
  EXPECT_EQ(markers[0].action, Marker::DELETEALL + 0);
}

TEST(CollisionMarkers, PointFromTheTipToWhatIsHitInEachLayerAndNameTheFirst) {
  Collision collision;
  collision.at = {7, 2, 3};
  collision.tip = {10, 20, 30};
  collision.link = "head";
  collision.obstacle = lamina::Obstacle::Material;
  collision.place = {11, 22, 33};
  ClearanceReport report;
  report.first_of_layers = {collision, collision};
  const auto markers = lamina::collisionMarkers(report, "bed").markers;
  ASSERT_EQ(markers.size(), 4U);
  for (const Marker& marker : markers) EXPECT_EQ(marker.header.frame_id, "bed");
  for (std::size_t i = 1; i < markers.size(); ++i) EXPECT_TRUE(markers[i].frame_locked) << i;
  EXPECT_NE(markers[1].id, markers[2].id);
  EXPECT_DOUBLE_EQ(markers[1].points.at(0).z, 0.030);
  EXPECT_DOUBLE_EQ(markers[1].points.at(1).x, 0.011);
  EXPECT_EQ(markers[3].text, "layer 7, path 2, waypoint 3: head in material");
}

}  // namespace
