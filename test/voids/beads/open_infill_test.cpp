// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/beads/open_infill.hpp"

#include <gtest/gtest.h>

#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

constexpr double kWidth = 0.4;
constexpr double kHeight = 0.2;

Path path(PathRole role, std::vector<Point3> points) {
  Path path;
  path.role = role;
  path.points = std::move(points);
  path.bead = beadOfArea(kWidth * kHeight, kHeight);
  path.feed_mm_s = 10.0;
  return path;
}

/// A square of 20 mm with one wall, and lines of infill so far apart.
ToolpathLayer square(double spacing_mm) {
  ToolpathLayer layer;
  layer.z_mm = layer.height_mm = kHeight;
  const double low = 0.5 * kWidth;
  const double high = 20.0 - low;
  Path wall = path(PathRole::OuterWall, {{low, low, kHeight}, {high, low, kHeight}, {high, high, kHeight}});
  wall.points.emplace_back(low, high, kHeight);
  wall.is_closed = true;
  layer.paths.push_back(wall);
  for (double y = low + kWidth; y < high; y += spacing_mm)
    layer.paths.push_back(path(PathRole::Infill, {{low + kWidth, y, kHeight}, {high - kWidth, y, kHeight}}));
  return layer;
}

double voidArea(const LayerVoids& layer) {
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
  const ToolpathLayer layer = square(2.0);
  EXPECT_GT(voidArea(findVoids(contour_, layer, {})), 250.0);
  EXPECT_LT(voidArea(kept(layer)), 1.0);
}

TEST_F(OpenInfillTest, OfAPartWithoutInfillIsOpenOnPurpose) { EXPECT_LT(voidArea(kept(square(100.0))), 1.0); }

TEST_F(OpenInfillTest, LeavesWhatASolidFillMissed) {
  ToolpathLayer layer = square(kWidth);
  layer.paths.erase(layer.paths.begin() + 20);
  const double missed_mm2 = voidArea(findVoids(contour_, layer, {}));
  EXPECT_GT(missed_mm2, 6.0);
  EXPECT_EQ(voidArea(kept(layer)), missed_mm2);
}

TEST_F(OpenInfillTest, LeavesAGapThatIsNarrow) {
  // Between wall and wall, with no infill: 1.2 mm, less than 3.2 beads.
  contour_ = {{rectangle(0, 0, 20, 2.0), {}}};
  ToolpathLayer layer = square(100.0);
  layer.paths.resize(1);
  for (Point3& point : layer.paths.front().points) point.y() = point.y() < 1.0 ? 0.2 : 1.8;
  const double gap_mm2 = voidArea(findVoids(contour_, layer, {}));
  EXPECT_GT(gap_mm2, 20.0);
  EXPECT_EQ(voidArea(kept(layer)), gap_mm2);
}

}  // namespace
}  // namespace lamina
