// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "markers/growing_part.hpp"

#include <gtest/gtest.h>

#include "support/toolpaths.hpp"

namespace lamina {
namespace {

using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

/// Two layers of a closed square wall, and a bead across.
Toolpath twoLayers() {
  Toolpath toolpath;
  for (int l = 0; l < 2; ++l) {
    const double z = 1.0 + l;
    Path wall = test::straightPath({0, 0, z}, {10, 0, z});
    wall.role = PathRole::OuterWall;
    wall.is_closed = true;
    wall.points = {{0, 0, z}, {10, 0, z}, {10, 10, z}, {0, 10, z}};
    Path travel = test::straightPath({0, 0, z}, {0, 5, z});
    travel.role = PathRole::Travel;
    travel.bead = Bead{};
    Path across = test::straightPath({0, 5, z}, {10, 5, z});
    across.role = PathRole::Infill;
    toolpath.layers.push_back({z, 1.0, {wall, travel, across}});
  }
  return toolpath;
}

std::size_t segments(const MarkerArray& markers) {
  std::size_t count = 0;
  for (const Marker& marker : markers.markers) count += marker.points.size() / 2;
  return count;
}

TEST(GrowingPart, HoldsTheMotionsThatAreDone) {
  const Toolpath toolpath = twoLayers();
  GrowingPart part(toolpath, "part");
  EXPECT_EQ(segments(part.upTo({0, 0, 1})), 0U) << "on the way to the first corner";
  EXPECT_EQ(segments(part.upTo({0, 0, 3})), 2U);
  EXPECT_EQ(segments(part.upTo({0, 0, 0})), 3U) << "on the way back to the start";
  EXPECT_EQ(segments(part.upTo({0, 1, 1})), 4U);
}

TEST(GrowingPart, SendsAgainOnlyTheLayerThatGrows) {
  const Toolpath toolpath = twoLayers();
  GrowingPart part(toolpath, "part");
  part.upTo({0, 2, 1});
  EXPECT_TRUE(part.upTo({0, 2, 1}).markers.empty()) << "nothing new";
  EXPECT_EQ(segments(part.upTo({1, 0, 1})), 5U) << "the rest of the first layer";
  EXPECT_EQ(segments(part.upTo({1, 0, 2})), 1U) << "the second alone";
}

TEST(GrowingPart, BeginsAnewWhenItGoesBack) {
  const Toolpath toolpath = twoLayers();
  GrowingPart part(toolpath, "part");
  part.upTo({1, 0, 2});
  const MarkerArray anew = part.upTo({0, 0, 2});
  ASSERT_FALSE(anew.markers.empty());
  EXPECT_EQ(anew.markers[0].action, Marker::DELETEALL);
  EXPECT_EQ(segments(anew), 1U);
}

TEST(GrowingPart, WholeHasAllThatIsDeposited) {
  const Toolpath toolpath = twoLayers();
  GrowingPart part(toolpath, "part");
  EXPECT_EQ(segments(part.whole()), 10U);
}

TEST(GrowingPart, WholeIsWholeWhateverWasShownBefore) {
  const Toolpath toolpath = twoLayers();
  GrowingPart part(toolpath, "part");
  part.upTo({1, 0, 2});
  const MarkerArray whole = part.whole();
  EXPECT_EQ(whole.markers.at(0).action, Marker::DELETEALL);
  EXPECT_EQ(segments(whole), 10U);
  EXPECT_EQ(segments(part.soFar()), 10U);
}

TEST(GrowingPart, HasAllLayersSoFarForWhoComesLate) {
  const Toolpath toolpath = twoLayers();
  GrowingPart part(toolpath, "part");
  EXPECT_EQ(segments(part.soFar()), 0U);
  part.upTo({1, 0, 2});
  const MarkerArray late = part.soFar();
  EXPECT_EQ(late.markers.at(0).action, Marker::DELETEALL);
  EXPECT_EQ(segments(late), 6U) << "five of the first layer, one of the second";
  EXPECT_EQ(segments(part.upTo({1, 0, 3})), 2U) << "others go on with the second layer alone";
}

TEST(GrowingPart, LiesHalfABeadBelowTheTipAndGoesWithTheTable) {
  const Toolpath toolpath = twoLayers();
  GrowingPart part(toolpath, "part");
  std::size_t shown = 0;
  for (const Marker& marker : part.whole().markers) {
    if (marker.action == Marker::DELETEALL) continue;
    shown += marker.points.size();
    EXPECT_TRUE(marker.frame_locked);
    EXPECT_EQ(marker.header.frame_id, "part");
    const double height = toolpath.layers[0].paths[0].bead.at(0).height_mm;
    const double z = toolpath.layers[static_cast<std::size_t>(marker.id) / kPathRoles].z_mm;
    for (const auto& point : marker.points) EXPECT_NEAR(point.z, 1e-3 * (z - 0.5 * height), 1e-9);
  }
  EXPECT_GT(shown, 0U);
}

}  // namespace
}  // namespace lamina
