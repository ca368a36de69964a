// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/octree_export.hpp"

#include <gtest/gtest.h>
#include <octomap/OcTree.h>

#include "lamina/base/error.hpp"
#include "support/scratch_folder.hpp"

namespace lamina {
namespace {

HeightMap slope() {
  HeightMap map(heightGrid({Point2(10, 10), Point2(14, 12)}, 0.5));
  for (std::size_t cell = 1; cell < map.grid().cellCount(); ++cell)
    map.set(cell, 0.3 * map.grid().centre(cell).x());
  return map;
}

TEST(OctreeExport, EachKnownCellIsAnOccupiedLeaf) {
  const HeightMap map = slope();
  const auto tree = octreeOf(map, 1e-3);
  EXPECT_DOUBLE_EQ(tree->getResolution(), 0.5e-3);
  for (std::size_t cell = 0; cell < map.grid().cellCount(); ++cell) {
    const Point2 centre = 1e-3 * map.grid().centre(cell);
    const double height = map.isKnown(cell) ? map.at(cell) : 0.3 * map.grid().centre(cell).x();
    const auto* leaf = tree->search(centre.x(), centre.y(), 1e-3 * height);
    ASSERT_EQ(leaf != nullptr, map.isKnown(cell)) << cell;
    EXPECT_TRUE(leaf == nullptr || tree->isNodeOccupied(leaf));
    EXPECT_EQ(tree->search(centre.x(), centre.y(), 1e-3 * (height + 1.0)), nullptr);
  }
}

TEST(OctreeExport, WhatIsWrittenReadsBack) {
  const test::ScratchFolder folder;
  const auto tree = octreeOf(slope(), 1e-3);
  writeOctree(folder.file("map.bt"), *tree);
  octomap::OcTree read(1.0);
  ASSERT_TRUE(read.readBinary(folder.file("map.bt")));
  EXPECT_EQ(read.getNumLeafNodes(), tree->getNumLeafNodes());
  EXPECT_DOUBLE_EQ(read.getResolution(), tree->getResolution());
}

TEST(OctreeExport, RefusesWhatTheTreeCannotReach) {
  HeightMap map(heightGrid({Point2(0, 0), Point2(1, 1)}, 0.01));
  map.set(0, 1000.0);
  EXPECT_THROW(octreeOf(map, 1e-3), InvalidInput);
}

TEST(OctreeExport, AFolderThatIsMissingIsAnError) {
  EXPECT_THROW(writeOctree("/nonexistent/map.bt", *octreeOf(slope(), 1e-3)), FileError);
}

}  // namespace
}  // namespace lamina
