// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/voxel/height_map.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <string>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"

namespace lamina {
namespace {

HeightGrid gridOf(double width, double depth, double cell) {
  return heightGrid({Point2(10, 20), Point2(10 + width, 20 + depth)}, cell);
}

TEST(HeightGrid, CoversItsAreaFromTheLowCorner) {
  const HeightGrid grid = gridOf(10.0, 4.9, 0.5);
  EXPECT_EQ(grid.columns, 20);
  EXPECT_EQ(grid.rows, 10);
  EXPECT_EQ(grid.centre(0, 0), Point2(10.25, 20.25));
}

TEST(HeightGrid, EveryCellContainsItsCentre) {
  const HeightGrid grid = gridOf(7.0, 3.0, 0.3);
  for (std::size_t cell = 0; cell < grid.cellCount(); ++cell) EXPECT_EQ(grid.cellAt(grid.centre(cell)), cell);
}

TEST(HeightGrid, PointsBeyondItHaveNoCell) {
  const HeightGrid grid = gridOf(10.0, 10.0, 1.0);
  EXPECT_EQ(grid.cellAt({10.0, 20.0}), 0u);
  EXPECT_EQ(grid.cellAt({20.0, 25.0}), HeightGrid::kNoCell);
  EXPECT_EQ(grid.cellAt({9.999, 25.0}), HeightGrid::kNoCell);
  EXPECT_EQ(grid.cellAt({NAN, 25.0}), HeightGrid::kNoCell);
  EXPECT_EQ(grid.cellAt({1e300, 25.0}), HeightGrid::kNoCell);
}

TEST(HeightGrid, RefusesTooManyCellsAndNamesTheSizeThatFits) {
  const Box2 area{Point2(0, 0), Point2(1000, 1000)};
  try {
    heightGrid(area, 0.1);
    FAIL() << "100 million cells were accepted";
  } catch (const InvalidInput& error) {
    const std::string message = error.what();
    const auto at = message.find("cell size of ");
    ASSERT_NE(at, std::string::npos) << message;
    EXPECT_NO_THROW(heightGrid(area, std::stod(message.substr(at + 13)) + 1e-6)) << message;
  }
}

TEST(HeightGrid, RefusesAnEmptyAreaAndACellWithoutSize) {
  EXPECT_THROW(heightGrid(Box2{}, 1.0), InvalidInput);
  EXPECT_THROW(heightGrid({Point2(0, 0), Point2(NAN, 1)}, 1.0), InvalidInput);
  EXPECT_THROW(gridOf(1, 1, 0.0), InvalidInput);
  EXPECT_THROW(gridOf(1, 1, NAN), InvalidInput);
}

TEST(HeightMap, BilinearLookupIsExactOnAPlane) {
  HeightMap map(gridOf(10.0, 10.0, 0.5));
  const auto plane = [](const Point2& p) { return 3.0 + 0.2 * p.x() - 0.1 * p.y(); };
  for (std::size_t cell = 0; cell < map.grid().cellCount(); ++cell)
    map.set(cell, plane(map.grid().centre(cell)));
  EXPECT_TRUE(rc::check("between the outermost centres", [&](std::uint64_t seed) {
    Random random(seed);
    const Point2 point(random.uniform(10.3, 19.7), random.uniform(20.3, 29.7));
    RC_ASSERT(std::abs(map.bilinear(point) - plane(point)) < 1e-12);
  }));
}

TEST(HeightMap, BilinearFallsBackToTheNearestCellBesideUnknownOnes) {
  HeightMap map(gridOf(2.0, 2.0, 1.0), 5.0);
  map.set(3, HeightMap::kUnknown);
  EXPECT_DOUBLE_EQ(map.bilinear({10.9, 20.9}), 5.0);
  EXPECT_TRUE(std::isnan(map.bilinear({11.2, 21.2})));
  EXPECT_TRUE(std::isnan(map.bilinear({30, 30})));
}

TEST(HeightMap, RangeAndVolumeSkipUnknownCells) {
  HeightMap map(gridOf(2.0, 1.0, 0.5));
  EXPECT_EQ(heightRange(map).known, 0u);
  EXPECT_TRUE(std::isnan(heightRange(map).low));
  map.set(1, 2.0);
  map.set(2, -4.0);
  EXPECT_EQ(heightRange(map).known, 2u);
  EXPECT_DOUBLE_EQ(heightRange(map).low, -4.0);
  EXPECT_DOUBLE_EQ(heightRange(map).high, 2.0);
  EXPECT_DOUBLE_EQ(volumeUnder(map), -0.5);
}

}  // namespace
}  // namespace lamina
