// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "markers/toolpath_markers.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace {

using lamina::Path;
using lamina::PathRole;
using lamina::Toolpath;
using visualization_msgs::Marker;

/// Layers with one closed triangle and one travel each.
Toolpath triangles(int layers) {
  Path wall;
  wall.role = PathRole::OuterWall;
  wall.is_closed = true;
  wall.points = {{0.0, 0.0, 0.2}, {10.0, 0.0, 0.2}, {10.0, 10.0, 0.2}};
  wall.bead = lamina::Bead{0.4, 0.2};
  Path travel;
  travel.role = PathRole::Travel;
  travel.points = {{0.0, 0.0, 0.2}, {5.0, 5.0, 0.2}};
  Toolpath toolpath;
  for (int i = 0; i < layers; ++i) toolpath.layers.push_back({0.2, 0.2, {wall, travel}});
  return toolpath;
}

TEST(ToolpathMarkers, BeginByDeletingTheOldOnes) {
  const auto markers = lamina::toolpathMarkers(Toolpath(), "part").markers;
  ASSERT_EQ(markers.size(), 1U);
  EXPECT_EQ(markers[0].action, Marker::DELETEALL + 0);
}

TEST(ToolpathMarkers, HoldEverySegmentOnceInTheNamespaceOfItsRole) {
  const int layers = 15000;
  std::map<std::string, std::size_t> points;
  std::set<int> ids;
  const auto markers = lamina::toolpathMarkers(triangles(layers), "part").markers;
  for (const Marker& marker : markers) {
    if (marker.action != Marker::ADD) continue;
    points[marker.ns] += marker.points.size();
    EXPECT_TRUE(ids.insert(marker.id).second);
    EXPECT_EQ(marker.header.frame_id, "part");
    EXPECT_TRUE(marker.frame_locked) << "tf may say later where the part stands";
    EXPECT_LT(marker.points.size(), 50000U);
  }
  EXPECT_EQ(points.at("outer_wall"), 3U * 2U * layers);
  EXPECT_EQ(points.at("travel"), 2U * layers);
  EXPECT_EQ(points.size(), 2U);
}

TEST(ToolpathMarkers, AreAQuarterAsWideAsTheBead) {
  const auto markers = lamina::toolpathMarkers(triangles(1), "part").markers;
  std::size_t walls = 0;
  for (const Marker& marker : markers)
    if (marker.ns == "outer_wall") {
      ++walls;
      EXPECT_DOUBLE_EQ(marker.scale.x, 0.0001);
      EXPECT_FLOAT_EQ(marker.color.a, 1.0F);
    }
  EXPECT_GT(walls, 0U);
}

TEST(ToolpathMarkers, ShowDropsAsSpheresOfTheirSize) {
  Toolpath toolpath = triangles(1);
  Path drops = toolpath.layers[0].paths[0];
  drops.deposit = lamina::Deposit::Drops;
  drops.is_closed = false;
  toolpath.layers[0].paths.push_back(drops);
  std::size_t spheres = 0;
  for (const Marker& marker : lamina::toolpathMarkers(toolpath, "part").markers) {
    if (marker.type != Marker::SPHERE_LIST || marker.points.empty()) continue;
    spheres += marker.points.size();
    EXPECT_EQ(marker.ns, "outer_wall");
    EXPECT_DOUBLE_EQ(marker.scale.x, 0.0004);
    EXPECT_DOUBLE_EQ(marker.scale.z, 0.0002);
  }
  EXPECT_EQ(spheres, 3U);
}

}  // namespace
