// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/control/layer_cells.hpp"

#include <gtest/gtest.h>

#include "lamina/base/error.hpp"
#include "support/control_layers.hpp"
#include "support/measured_layers.hpp"
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

TEST(LayerCells, TakeAPointThatStandsTwiceForNoCorner) {
  ToolpathLayer layer = test::straightBeadLayer({0.0}, 100.0);
  const Point3 middle(50, 0, 1.5);
  layer.paths[0].points.insert(layer.paths[0].points.begin() + 1, {middle, middle});
  const LayerCells cells = layerCells(layer, 0, 1.0);
  EXPECT_EQ(cells.region[50], CellRegion::Straight);
}

TEST(LayerCells, LeaveBuildAidsOut) {
  ToolpathLayer layer = test::straightBeadLayer({0.0}, 10.0);
  layer.paths[0].role = PathRole::Skirt;
  EXPECT_EQ(layerCells(layer, 0, 1.0).size(), 0U);
}

TEST(LayerCells, RefuseALengthThatIsNone) {
  EXPECT_THROW(layerCells(test::straightBeadLayer({0.0}, 10.0), 0, 0.0), InvalidInput);
}

TEST(LayerCells, KnowTheirWayAndGrowth) {
  for (const test::MeasuredLayer& measured : test::measuredLayers(3, {1.2, 0.3})) {
    const LayerCells cells = test::cellsOf(measured);
    for (std::size_t bead = 0; bead < cells.runs.size(); ++bead) {
      const CellRun& run = cells.runs[bead];
      for (std::size_t i = 0; i < run.count; ++i) {
        const double way = (double(i) + 0.5) / double(run.count);
        const Eigen::Vector3d growth = measured.growth(bead, way);
        EXPECT_NEAR((cells.growth[run.first + i] - growth).norm(), 0.0, 1e-7) << measured.name;
        const Eigen::Vector3d tangent = measured.across(bead, way).cross(growth);
        EXPECT_NEAR((cells.tangent[run.first + i] - tangent).norm(), 0.0, 1e-7) << measured.name;
      }
    }
  }
}

TEST(LayerCells, GrowSquareToAPathThatTheNozzleTrails) {
  ToolpathLayer layer = test::straightBeadLayer({0.0}, 10.0);
  layer.paths[0].points[1].z() += 10.0;  // climbs at 45 degrees, the nozzle straight down
  const LayerCells cells = layerCells(layer, 0, 1.0);
  for (const Eigen::Vector3d& growth : cells.growth)
    EXPECT_NEAR((growth - Eigen::Vector3d(-1, 0, 1).normalized()).norm(), 0.0, 1e-12);
}

TEST(LayerCells, ArePassedInTheOrderInWhichTheyAreDeposited) {
  const LayerCells cells = test::straightBeads({0.0, 3.0}, 10.0, 1.0);  // paths 0 and 2
  EXPECT_EQ(cellsPassed(cells, 0, 0.0, 0.0), 0U);
  EXPECT_EQ(cellsPassed(cells, 0, 4.5, 0.0), 4U);
  EXPECT_EQ(cellsPassed(cells, 0, 4.5, 3.0), 1U);
  EXPECT_EQ(cellsPassed(cells, 1, 1.0, 0.0), 10U) << "on the travel between";
  EXPECT_EQ(cellsPassed(cells, 1, 1.0, 3.0), 7U) << "nothing is deposited on it";
  EXPECT_EQ(cellsPassed(cells, 2, 1.0, 3.0), 8U);
  EXPECT_EQ(cellsPassed(cells, 2, 10.0, 0.0), 20U);
  EXPECT_EQ(cellsPassed(cells, 9, 0.0, 3.0), 17U);
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
