// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/monitoring/expected_surface.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <set>

#include "lamina/base/random.hpp"
#include "lamina/geometry/spatial/cells_near_segment.hpp"
#include "support/scanned_plates.hpp"

namespace lamina {
namespace {

HeightGrid bed(double cell = 0.1) { return heightGrid({Point2(0, 0), Point2(40, 40)}, cell); }

ToolpathLayer oneBead(const Point3& start, const Point3& end, const Bead& bead,
                      PathRole role = PathRole::Infill) {
  Path path;
  path.role = role;
  path.points = {start, end};
  path.bead = bead;
  path.feed_mm_s = 50.0;
  ToolpathLayer layer;
  layer.z_mm = start.z();
  layer.height_mm = bead.height_mm;
  layer.paths = {path};
  return layer;
}

TEST(ExpectedSurface, ATwoLayerStepHasTwoHeights) {
  const Toolpath step = scannedPlates({{{5, 5}, {25, 15}}, {{5, 5}, {15, 15}}});
  ExpectedSurface expected(bed(), Eigen::Isometry3d::Identity());
  expected.addLayer(step.layers[0]);
  EXPECT_DOUBLE_EQ(expected.heights().nearest({10, 10}), 0.2);
  expected.addLayer(step.layers[1]);
  EXPECT_DOUBLE_EQ(expected.heights().nearest({10, 10}), 0.4);
  EXPECT_DOUBLE_EQ(expected.heights().nearest({20, 10}), 0.2);
  EXPECT_TRUE(std::isnan(expected.heights().nearest({30, 10})));
}

TEST(ExpectedSurface, DropsStandAloneAndNothingBetweenThem) {
  ToolpathLayer layer = oneBead({10, 10, 0.2}, {12, 10, 0.2}, {0.8, 0.2});
  layer.paths[0].deposit = Deposit::Drops;
  ExpectedSurface expected(bed(0.02), Eigen::Isometry3d::Identity());
  expected.addLayer(layer);
  EXPECT_DOUBLE_EQ(expected.heights().nearest({10, 10}), 0.2);
  EXPECT_DOUBLE_EQ(expected.heights().nearest({12, 10.39}), 0.2);
  EXPECT_TRUE(std::isnan(expected.heights().nearest({11, 10})));
  const double two_discs = 2.0 * M_PI * 0.4 * 0.4;
  EXPECT_NEAR(double(heightRange(expected.heights()).known) * 0.02 * 0.02, two_discs, 0.02 * two_discs);
}

TEST(ExpectedSurface, ABeadCoversItsWidthAndLength) {
  ExpectedSurface expected(bed(0.05), Eigen::Isometry3d::Identity());
  expected.addLayer(oneBead({10, 10, 0.2}, {29.3, 17.71, 0.2}, {0.6, 0.2}));
  const HeightRange range = heightRange(expected.heights());
  const double area = std::hypot(19.3, 7.71) * 0.6 + M_PI * 0.3 * 0.3;
  EXPECT_NEAR(double(range.known) * 0.05 * 0.05, area, 0.01 * area);
}

TEST(ExpectedSurface, TopCellsLieOnTheFlatOfTheBead) {
  ExpectedSurface expected(bed(), Eigen::Isometry3d::Identity());
  expected.addLayer(oneBead({10, 10, 0.2}, {30, 10, 0.2}, {0.6, 0.2}));
  ASSERT_FALSE(expected.topCells().empty());
  const std::set<std::size_t> unique(expected.topCells().begin(), expected.topCells().end());
  EXPECT_EQ(unique.size(), expected.topCells().size());
  for (const std::size_t cell : expected.topCells())
    EXPECT_LE(std::abs(bed().centre(cell).y() - 10.0), 0.2 + 1e-9);
}

TEST(ExpectedSurface, SkirtsAreExpectedButNotCompared) {
  ExpectedSurface expected(bed(), Eigen::Isometry3d::Identity());
  expected.addLayer(oneBead({10, 10, 0.2}, {30, 10, 0.2}, {0.6, 0.2}, PathRole::Skirt));
  EXPECT_DOUBLE_EQ(expected.heights().nearest({20, 10}), 0.2);
  EXPECT_TRUE(expected.topCells().empty());
}

TEST(ExpectedSurface, StandsWhereThePartStandsOnTheBed) {
  Eigen::Isometry3d bed_from_part = Eigen::Isometry3d::Identity();
  bed_from_part.translation() = Point3(20, 20, 0.05);
  bed_from_part.rotate(Eigen::AngleAxisd(M_PI / 2, Point3::UnitZ()));
  ExpectedSurface expected(bed(), bed_from_part);
  expected.addLayer(oneBead({0, 0, 0.2}, {10, 0, 0.2}, {0.6, 0.2}));
  EXPECT_NEAR(expected.heights().nearest({20, 28}), 0.25, 1e-12);
  EXPECT_TRUE(std::isnan(expected.heights().nearest({28, 20})));
}

TEST(CellsNearSegment, AreThoseWhoseCentresAreWithinReach) {
  EXPECT_TRUE(rc::check("for any segment, also beyond the grid", [](std::uint64_t seed) {
    Random random(seed);
    const HeightGrid grid = heightGrid({Point2(-3, 2), Point2(17, 12)}, 0.5);
    const Point2 start(random.uniform(-10, 25), random.uniform(-5, 20));
    Point2 end(random.uniform(-10, 25), random.uniform(-5, 20));
    if (random.below(4) == 0) end.y() = start.y();
    if (random.below(4) == 0) end = start;
    const double reach = random.uniform(0.0, 4.0);
    std::set<std::size_t> near;
    forCellsNearSegment(grid, start, end, reach,
                        [&](std::size_t cell, double, double) { near.insert(cell); });
    for (std::size_t cell = 0; cell < grid.cellCount(); ++cell) {
      const Point2 along = end - start, from = grid.centre(cell) - start;
      const double at = along.norm() > 0 ? std::clamp(from.dot(along) / along.squaredNorm(), 0.0, 1.0) : 0.0;
      const double distance = (from - at * along).norm();
      RC_ASSERT(std::abs(distance - reach) < 1e-9 || (distance < reach) == (near.count(cell) == 1));
    }
  }));
}

}  // namespace
}  // namespace lamina
