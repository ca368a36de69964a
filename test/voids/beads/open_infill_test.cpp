// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/beads/open_infill.hpp"

#include <gtest/gtest.h>

#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

constexpr double kBeadWidth = 0.4;
constexpr double kLayer = 0.2;

Path linePath(PathRole role, std::vector<Point3> points) {
  Path path;
  path.role = role;
  path.points = std::move(points);
  path.bead = beadOfArea(kBeadWidth * kLayer, kLayer);
  path.feed_mm_s = 10.0;
  return path;
}

/// A square of 20 mm with one wall, and lines of infill so far apart.
ToolpathLayer linedSquare(double spacing_mm) {
  ToolpathLayer layer;
  layer.z_mm = layer.height_mm = kLayer;
  const double low = 0.5 * kBeadWidth;
  const double high = 20.0 - low;
  Path wall = linePath(PathRole::OuterWall, {{low, low, kLayer}, {high, low, kLayer}, {high, high, kLayer}});
  wall.points.emplace_back(low, high, kLayer);
  wall.is_closed = true;
  layer.paths.push_back(wall);
  for (double y = low + kBeadWidth; y < high; y += spacing_mm)
    layer.paths.push_back(
        linePath(PathRole::Infill, {{low + kBeadWidth, y, kLayer}, {high - kBeadWidth, y, kLayer}}));
  return layer;
}

double listedArea(const LayerVoids& layer) {
  double area_mm2 = 0.0;
  for (const Void& each : layer.voids) area_mm2 += each.area_mm2;
  return area_mm2;
}

class OpenInfillTest : public ::testing::Test {
 protected:
  LayerVoids kept(const ToolpathLayer& layer) const {
    return withoutOpenInfill(findVoids(contour_, layer, {}), contour_, layer, {});
  }

  Regions contour_ = {{rectangle(0, 0, 20, 20), {}}};
};

TEST_F(OpenInfillTest, OfLinesFarApartIsOpenOnPurpose) {
  const ToolpathLayer layer = linedSquare(2.0);
  EXPECT_GT(listedArea(findVoids(contour_, layer, {})), 250.0);
  EXPECT_LT(listedArea(kept(layer)), 1.0);
}

TEST_F(OpenInfillTest, OfAPartWithoutInfillIsOpenOnPurpose) {
  EXPECT_LT(listedArea(kept(linedSquare(100.0))), 1.0);
}

TEST_F(OpenInfillTest, LeavesWhatASolidFillMissed) {
  ToolpathLayer layer = linedSquare(kBeadWidth);
  layer.paths.erase(layer.paths.begin() + 20);
  const double missed_mm2 = listedArea(findVoids(contour_, layer, {}));
  EXPECT_GT(missed_mm2, 6.0);
  EXPECT_EQ(listedArea(kept(layer)), missed_mm2);
}

TEST_F(OpenInfillTest, LeavesAGapThatIsNarrow) {
  // Between wall and wall, with no infill: 1.2 mm, less than 3.2 beads.
  contour_ = {{rectangle(0, 0, 20, 2.0), {}}};
  ToolpathLayer layer = linedSquare(100.0);
  layer.paths.resize(1);
  for (Point3& point : layer.paths.front().points) point.y() = point.y() < 1.0 ? 0.2 : 1.8;
  const double gap_mm2 = listedArea(findVoids(contour_, layer, {}));
  EXPECT_GT(gap_mm2, 20.0);
  EXPECT_EQ(listedArea(kept(layer)), gap_mm2);
}

}  // namespace
}  // namespace lamina
