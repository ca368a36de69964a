// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/replanned_toolpath.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "lamina/toolpath/layer_frame.hpp"
#include "support/sensed_wall.hpp"

namespace lamina {
namespace {

Toolpath eightLayers() { return test::scannedWall(test::SensedWallCase()); }  // of 1.5 mm

TEST(ReplannedToolpath, EndsAtThePlannedTop) {
  const LayersLeft left{5, 0.6};
  const PartUnderWay part = partUnderWay(eightLayers(), left, 0.8);
  EXPECT_EQ(part.heights_left_mm, (std::vector<double>{1.5, 1.5, 1.5}));
  const auto heights = newHeights(part, Replanning::Scale);
  ASSERT_TRUE(heights);
  const Toolpath replanned = replannedToolpath(eightLayers(), left, *heights);
  ASSERT_EQ(replanned.layers.size(), 3U);
  // 7.5 mm less 0.6 are there; 5.1 mm are left for three layers.
  for (std::size_t i = 0; i < 3; ++i) {
    const double top = 6.9 + 1.7 * static_cast<double>(i + 1);
    EXPECT_NEAR(replanned.layers[i].z_mm, top, 1e-9);
    EXPECT_NEAR(replanned.layers[i].height_mm, 1.7, 1e-9);
    const Path& bead = replanned.layers[i].paths[0];
    EXPECT_NEAR(bead.points[1].z(), top, 1e-9);
    EXPECT_NEAR(bead.bead.at(1).height_mm, 1.7, 1e-9);
    EXPECT_NEAR(crossSection(bead.bead.at(1)), crossSection({3.0, 1.7}) / 0.8, 1e-9)
        << "growth is in the plan";
    EXPECT_EQ(bead.feed_mm_s.at(1), 20.0);
  }
  EXPECT_NO_THROW(validate(replanned));
}

TEST(ReplannedToolpath, HasMoreOrFewerLayersWhereAsked) {
  const LayersLeft left{4, 3.2};
  const auto more = newHeights(partUnderWay(eightLayers(), left, 1.0), Replanning::Add);
  ASSERT_TRUE(more);
  const Toolpath replanned = replannedToolpath(eightLayers(), left, *more);
  ASSERT_EQ(replanned.layers.size(), 6U);  // 9.2 mm
  EXPECT_NEAR(replanned.layers.back().z_mm, 12.0 - 0.2, 1e-9) << "within half a layer of the top";
  const auto fewer = newHeights(partUnderWay(eightLayers(), {4, -3.2}, 1.0), Replanning::Add);
  ASSERT_TRUE(fewer);
  EXPECT_EQ(replannedToolpath(eightLayers(), {4, -3.2}, *fewer).layers.size(), 2U);
  EXPECT_FALSE(newHeights(partUnderWay(eightLayers(), left, 1.0), Replanning::Off));
  EXPECT_FALSE(newHeights(partUnderWay(eightLayers(), left, 1.0), Replanning::Hold));
}

TEST(ReplannedToolpath, HasAnIdentityThatNamesItsParent) {
  const NewHeights heights{{1.6, 1.6}, 1.0};
  const Toolpath first = replannedToolpath(eightLayers(), {6, 0.2}, heights);
  const std::string parent = toolpathId(eightLayers());
  const std::string id = replannedId(first, 6, parent);
  EXPECT_EQ(id, toolpathId(first) + "-from-6-of-" + parent);
  EXPECT_EQ(replannedId(eightLayers(), 1, id), parent + "-from-1-of-" + toolpathId(first))
      << "of a plan of a plan";
}

TEST(ReplannedToolpath, IsBegunInPlaceOfTheLayerThatItsIdentityNames) {
  EXPECT_EQ(firstLayerOf("b-from-6-of-a"), 6U);
  EXPECT_EQ(firstLayerOf("c-from-12-of-b"), 12U);
  EXPECT_FALSE(firstLayerOf("a"));
  EXPECT_FALSE(firstLayerOf("b-of-a"));
  EXPECT_FALSE(firstLayerOf("b-from--of-a"));
  EXPECT_FALSE(firstLayerOf("b-from-6x-of-a"));
  EXPECT_FALSE(firstLayerOf("b-from--6-of-a"));
  EXPECT_FALSE(firstLayerOf("b-of-a-from-6"));
  EXPECT_FALSE(firstLayerOf("b-from-99999999999999999999999-of-a"));
}

/// Layers that lean grow along their normal.
TEST(ReplannedToolpath, FollowsTheNormalOfInclinedLayers) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(M_PI / 4.0, Eigen::Vector3d::UnitX()));
  const LayersLeft left{6, 0.3};
  const NewHeights heights{{1.65, 1.65}, 1.0};
  const Toolpath level = replannedToolpath(eightLayers(), left, heights);
  const Toolpath inclined = replannedToolpath(turned(eightLayers(), turn), left, heights);
  for (std::size_t i = 0; i < level.layers.size(); ++i) {
    const Path& path = inclined.layers[i].paths[0];
    for (std::size_t p = 0; p < path.points.size(); ++p)
      EXPECT_LT((turn * level.layers[i].paths[0].points[p] - path.points[p]).norm(), 1e-9);
  }
}

TEST(ReplannedToolpath, RefusesWhatItCannotPlan) {
  const NewHeights heights{{1.6, 1.6}, 1.0};
  EXPECT_THROW(partUnderWay(eightLayers(), {8, 0.0}, 1.0), InvalidInput) << "nothing is left";
  Toolpath curved = eightLayers();
  curved.layers[6].paths[0].points[1].z() += 0.5;
  curved.layers[6].paths[1].points[0].z() += 0.5;
  EXPECT_THROW(replannedToolpath(curved, {5, 0.2}, heights), InvalidInput);
  EXPECT_NO_THROW(replannedToolpath(curved, {7, 0.2}, heights)) << "it is deposited already";
  Toolpath uneven = eightLayers();
  uneven.layers[7].height_mm = 1.0;
  EXPECT_THROW(replannedToolpath(uneven, {5, 0.2}, heights), InvalidInput);
  Toolpath drops = eightLayers();
  drops.layers[7].paths[0].deposit = Deposit::Drops;
  EXPECT_THROW(replannedToolpath(drops, {5, 0.2}, heights), InvalidInput);
}

TEST(ReplannedToolpath, RefusesLayersWithoutATravelBetweenThem) {
  Toolpath wound = eightLayers();
  for (std::size_t k = 0; k < 8; ++k) {
    wound.layers[k].paths.pop_back();
    auto& points = wound.layers[k].paths[0].points;
    if (k % 2 == 1) std::swap(points[0], points[1]);
  }
  EXPECT_THROW(replannedToolpath(wound, {5, 0.2}, {{1.6, 1.6, 1.6}, 1.0}), InvalidInput);
}

TEST(ReplannedToolpath, IsOfThePrintThatItsNameSays) {
  EXPECT_TRUE(isPlanOf("b-of-a", "a"));
  EXPECT_TRUE(isPlanOf("c-of-b", "b-of-a")) << "a plan of what is a plan";
  EXPECT_TRUE(isPlanOf("b-from-3-of-a", "a"));
  EXPECT_TRUE(isPlanOf("c-from-2-of-b", "b-from-3-of-a"));
  EXPECT_FALSE(isPlanOf("c-from-2-of-a", "b-from-3-of-a"));
  EXPECT_FALSE(isPlanOf("c-of-a", "b-of-a")) << "of what is no longer driven";
  EXPECT_FALSE(isPlanOf("b-of-a", "b-of-a")) << "itself";
  EXPECT_FALSE(isPlanOf("b-of-a", "b"));
  EXPECT_FALSE(isPlanOf("a", "a"));
  EXPECT_FALSE(isPlanOf("b-of-a", "ab"));
}

}  // namespace
}  // namespace lamina
