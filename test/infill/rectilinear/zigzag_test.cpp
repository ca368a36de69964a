// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/rectilinear/zigzag.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "support/fill_requests.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;
using test::requestOf;
using test::reversed;

double totalLength(const std::vector<FillPath>& paths) {
  double sum = 0.0;
  for (const FillPath& path : paths) sum += length(path.points);
  return sum;
}

/// Moves along x that are at least 1 mm long: the lines of a raster of angle 0.
int countLines(const std::vector<FillPath>& paths) {
  int count = 0;
  for (const FillPath& path : paths)
    for (std::size_t i = 1; i < path.points.size(); ++i) {
      const Point2 move = path.points[i] - path.points[i - 1];
      count += std::abs(move.y()) < 1e-9 && std::abs(move.x()) > 1.0 ? 1 : 0;
    }
  return count;
}

TEST(Zigzag, FillsASquareInOneRun) {
  // Lines at y = 1, 2, ..., 9 and nine links of 1 mm less one.
  const std::vector<FillPath> paths = rasterRuns({{rectangle(0.5, 0.5, 9.5, 9.5), {}}}, requestOf(1.0, 0.0));
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_EQ(countLines(paths), 9);
  EXPECT_NEAR(totalLength(paths), 9 * 9.0 + 8 * 1.0, 1e-9);
}

TEST(Zigzag, CountsALineAtTheBottomAndNoneAtTheTop) {
  EXPECT_EQ(countLines(rasterRuns({{rectangle(0, 0, 10, 10), {}}}, requestOf(1.0, 0.0))), 10);
}

TEST(Zigzag, TurnsWithItsAngle) {
  const std::vector<FillPath> paths =
      rasterRuns({{rectangle(0.5, 0.5, 9.5, 4.5), {}}}, requestOf(1.0, M_PI / 2));
  ASSERT_EQ(paths.size(), 1U);
  EXPECT_NEAR(totalLength(paths), 9 * 4.0 + 8 * 1.0, 1e-9);
  EXPECT_NEAR((paths[0].points[1] - paths[0].points[0]).x(), 0.0, 1e-9);
}

TEST(Zigzag, KeepsItsRasterWhereverTheRegionLies) {
  const std::vector<FillPath> runs =
      rasterRuns({{rectangle(3.3, 7.7, 12.1, 20.9), {}}}, requestOf(0.75, 0.0));
  ASSERT_FALSE(runs.empty());
  for (const FillPath& path : runs)
    for (const Point2& point : path.points)
      EXPECT_NEAR(std::remainder(point.y(), 0.75), 0.0, 1e-9)
          << "the links of a rectangle have no points of their own";
}

TEST(Zigzag, DepositsInverselyToItsSpacing) {
  const Regions square = {{rectangle(0, 0, 100, 100), {}}};
  const double fine = totalLength(rasterRuns(square, requestOf(0.5, 0.7)));
  const double coarse = totalLength(rasterRuns(square, requestOf(2.0, 0.7)));
  // Without links, area / spacing; those add at most three spacings a line.
  EXPECT_NEAR(fine, 100 * 100 / 0.5, 0.02 * fine);
  EXPECT_NEAR(coarse, 100 * 100 / 2.0, 0.06 * coarse);
}

TEST(Zigzag, GoesRoundAHoleInTwoRunsBesideIt) {
  const Regions ring = {{rectangle(0.5, 0.5, 19.5, 19.5), {reversed(rectangle(5.5, 5.5, 14.5, 14.5))}}};
  const std::vector<FillPath> paths = rasterRuns(ring, requestOf(1.0, 0.0));
  // 19 lines of 19 mm, 9 of them cut by the hole of 9 mm into two.
  EXPECT_EQ(countLines(paths), 19 + 9);
  EXPECT_LE(paths.size(), 3U);
}

TEST(Zigzag, DoesNotJoinRunsOfTwoOutlines) {
  const Regions islands = {{rectangle(0, 0.5, 5, 5.5), {}}, {rectangle(10, 0.5, 15, 5.5), {}}};
  EXPECT_EQ(joinedRasterRuns(islands, requestOf(1.0, 0.0), 1000.0).size(), 2U);
}

TEST(Zigzag, FillsTwoIslandsApart) {
  const std::vector<FillPath> paths =
      rasterRuns({{rectangle(0, 0.5, 5, 5.5), {}}, {rectangle(10, 0.5, 15, 5.5), {}}}, requestOf(1.0, 0.0));
  ASSERT_EQ(paths.size(), 2U);
  EXPECT_LT(paths[0].points.front().x(), 6.0);
  EXPECT_GT(paths[1].points.front().x(), 9.0);
}

TEST(Zigzag, FollowsTheOutlineBetweenItsLines) {
  // A notch between two lines: the link goes round it instead of across.
  const Polygon notched = {{0, 0.5}, {10, 0.5}, {10, 1.3}, {9.5, 1.5}, {10, 1.7}, {10, 2.5}, {0, 2.5}};
  const std::vector<FillPath> paths = rasterRuns({{notched, {}}}, requestOf(1.0, 0.0));
  ASSERT_EQ(paths.size(), 1U);
  const Polyline& points = paths[0].points;
  EXPECT_EQ(points.size(), 7U);
  EXPECT_NEAR(totalLength(paths), 10 + 10 + 2 * 0.3 + 2 * std::hypot(0.5, 0.2), 1e-9);
}

TEST(Zigzag, FollowsALongWayRoundIfItMay) {
  // Between y = 1 and y = 2 both sides lead far out and back.
  const Polygon winged = {{0, 0.5},  {10, 0.5}, {10, 1.4}, {30, 1.5},  {10, 1.6},
                          {10, 2.5}, {0, 2.5},  {0, 1.6},  {-20, 1.5}, {0, 1.4}};
  const InfillRequest request = requestOf(1.0, 0.0);
  EXPECT_EQ(rasterRuns({{winged, {}}}, request).size(), 2U);
  const double way = 0.4 + 2 * std::hypot(20.0, 0.1) + 0.4;
  EXPECT_EQ(joinedRasterRuns({{winged, {}}}, request, way - 0.01).size(), 2U);
  const std::vector<FillPath> joined = joinedRasterRuns({{winged, {}}}, request, way + 0.01);
  ASSERT_EQ(joined.size(), 1U);
  EXPECT_NEAR(totalLength(joined), 10 + way + 10, 1e-9);
}

}  // namespace
}  // namespace lamina
