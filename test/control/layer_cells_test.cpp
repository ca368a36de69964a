// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/layer_cells.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "support/control_layers.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

TEST(LayerCells, CutEachDepositingPathIntoEqualPieces) {
  const LayerCells cells = test::straightBeads({0.0, 3.0}, 10.0, 0.6);
  ASSERT_EQ(cells.runs.size(), 2U);
  EXPECT_EQ(cells.runs[0].path, 0U);
  EXPECT_EQ(cells.runs[1].path, 2U) << "the travel counts as a path";
  EXPECT_EQ(cells.runs[0].count, 17U);  // 10 / 0.6 = 16.7
  EXPECT_EQ(cells.size(), 34U);
  EXPECT_NEAR(cells.along_mm[0], 0.5 * 10.0 / 17.0, 1e-12);
  EXPECT_NEAR(cells.middle[33].x(), 10.0 - 0.5 * 10.0 / 17.0, 1e-12);
  EXPECT_EQ(cells.middle[33].y(), 3.0);
  EXPECT_EQ(cells.height_mm[20], 1.5);
  EXPECT_EQ(cells.speed_mm_s[20], 10.0);
}

TEST(LayerCells, GoRoundAClosedPath) {
  const LayerCells cells = layerCells(test::twoLayers().layers[0], 0, 1.0);
  ASSERT_EQ(cells.runs.size(), 1U);
  EXPECT_TRUE(cells.runs[0].is_closed);
  EXPECT_EQ(cells.runs[0].count, 40U);
  EXPECT_TRUE(cells.middle[35].isApprox(Point3(0, 4.5, 0.2)));
  for (const CellRegion region : cells.region) EXPECT_EQ(region, CellRegion::Corner);
}

TEST(LayerCells, KnowEnds) {
  const LayerCells cells = test::straightBeads({0.0}, 100.0, 1.0);
  EXPECT_EQ(cells.region[9], CellRegion::End);
  EXPECT_EQ(cells.region[10], CellRegion::Straight);
  EXPECT_EQ(cells.region[89], CellRegion::Straight);
  EXPECT_EQ(cells.region[90], CellRegion::End);
}

TEST(LayerCells, LeaveBuildAidsOut) {
  ToolpathLayer layer = test::straightBeadLayer({0.0}, 10.0);
  layer.paths[0].role = PathRole::Skirt;
  EXPECT_EQ(layerCells(layer, 0, 1.0).size(), 0U);
}

TEST(LayerCells, RefuseALengthThatIsNone) {
  EXPECT_THROW(layerCells(test::straightBeadLayer({0.0}, 10.0), 0, 0.0), InvalidInput);
}

TEST(LayerCells, StandOnTheNearestOnesBelow) {
  const LayerCells below = test::straightBeads({0.0, 3.0}, 10.0, 1.0);
  const LayerCells above = layerCells(test::straightBeadLayer({2.8, 40.0}, 10.0, 3.0), 1, 1.0);
  const auto found = cellsBelow(above, below, Eigen::Vector3d::UnitZ());
  EXPECT_EQ(found[4], 14U);
  EXPECT_EQ(found[14], kNoCellBelow);
}

}  // namespace
}  // namespace lamina
