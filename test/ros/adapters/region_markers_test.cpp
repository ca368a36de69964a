// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "markers/region_markers.hpp"

#include <gtest/gtest.h>

#include "lamina/geometry/parts/parts.hpp"

namespace {

using visualization_msgs::Marker;

TEST(RegionMarkers, ShowTheRegionOnThePartWithTheReason) {
  const lamina::Mesh part = lamina::makePart("box");
  lamina::Mesh region = part;
  region.triangles.resize(2);
  const lamina::Unsliceable refusal = lamina::Unsliceable("too level", region).withPart(part);
  const auto markers = lamina::regionMarkers(refusal, "part").markers;
  ASSERT_EQ(markers.size(), 4U);
  EXPECT_EQ(markers[0].action, Marker::DELETEALL + 0);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_TRUE(markers[i].frame_locked) << i;
  EXPECT_EQ(markers[1].ns, "region");
  EXPECT_EQ(markers[1].points.size(), 6U);
  EXPECT_EQ(markers[2].ns, "part");
  EXPECT_EQ(markers[2].points.size(), 3 * part.triangles.size());
  EXPECT_EQ(markers[3].text, "too level");
  EXPECT_GT(markers[3].pose.position.z, lamina::boundingBox(part).high.z() / 1e3);
}

TEST(RegionMarkers, OfNoRefusalDeleteTheOldOnes) {
  ASSERT_EQ(lamina::noRegionMarkers("part").markers.size(), 1U);
  EXPECT_EQ(lamina::noRegionMarkers("part").markers[0].action, Marker::DELETEALL + 0);
}

}  // namespace
