// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/supports/laid_supports.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "support/supported_parts.hpp"

namespace lamina {
namespace {

Path runOfPart(const Point2& from, const Point2& to, double z_mm) {
  Path path;
  path.role = PathRole::OuterWall;
  path.points = {{from.x(), from.y(), z_mm}, {to.x(), to.y(), z_mm}};
  path.bead = Bead{0.4, 0.2};
  path.feed_mm_s = 30.0;
  return path;
}

AidRuns supports(std::vector<FillPath> runs, double top_mm) {
  AidRuns aids;
  for (FillPath& run : runs) run.role = PathRole::Support;
  aids.runs = std::make_shared<const std::vector<FillPath>>(std::move(runs));
  aids.bead = {0.4, 0.2};
  aids.top_mm = top_mm;
  return aids;
}

FillPath supportLine(const Point2& from, const Point2& to) {
  FillPath run;
  run.points = {from, to};
  return run;
}

/// Two layers of a part, the second with supports: the first ends at (50, 0), where the second comes from,
/// and the part of the second begins at (0, 0).
std::vector<Path> secondLayerWith(LayerAids aids) {
  std::vector<ToolpathLayer> layers(2);
  layers[0].paths = {runOfPart({60, 0}, {50, 0}, 0.2)};
  layers[1].paths = {runOfPart({0, 0}, {0, 10}, 0.4)};
  const PlanSettings settings;
  laySupports(layers, {{}, std::move(aids)}, {settings, settings, settings.travel, Point2::Zero()});
  return layers[1].paths;
}

std::vector<Path> withoutTravels(std::vector<Path> paths) {
  paths.erase(std::remove_if(paths.begin(), paths.end(),
                             [](const Path& path) { return path.role == PathRole::Travel; }),
              paths.end());
  return paths;
}

TEST(LaidSupports, LeadFromTheLayerBeforeToThePart) {
  std::vector<FillPath> lines;
  for (const double x : {10.0, 20.0, 30.0, 40.0}) lines.push_back(supportLine({x, 0}, {x, 5}));
  const std::vector<Path> paths = withoutTravels(secondLayerWith({supports(std::move(lines), 0.4)}));
  ASSERT_EQ(paths.size(), 5U);
  EXPECT_EQ(paths.back().role, PathRole::OuterWall);
  double x = 40.0;
  for (std::size_t i = 0; i < 4; ++i, x -= 10.0) {
    EXPECT_EQ(paths[i].firstPoint().x(), x) << "to and fro, from the right";
    EXPECT_EQ(paths[i].firstPoint().y(), i % 2 == 0 ? 0.0 : 5.0);
  }
}

TEST(LaidSupports, AreJoinedByTravelsWithinTheirLayer) {
  const std::vector<Path> paths =
      secondLayerWith({supports({supportLine({30, 0}, {30, 5}), supportLine({20, 0}, {20, 5})}, 0.4)});
  ASSERT_EQ(paths.size(), 5U) << "support, travel, support, travel, part";
  for (std::size_t i = 0; i + 1 < paths.size(); ++i)
    EXPECT_EQ(paths[i].lastPoint(), paths[i + 1].firstPoint()) << i;
}

TEST(LaidSupports, LieFromTheBottomUp) {
  const std::vector<Path> paths = withoutTravels(secondLayerWith(
      {supports({supportLine({10, 0}, {10, 5})}, 0.3), supports({supportLine({40, 0}, {40, 5})}, 0.4)}));
  ASSERT_EQ(paths.size(), 3U);
  EXPECT_EQ(paths[0].firstPoint().z(), 0.3) << "though it is farther away";
  EXPECT_EQ(paths[1].firstPoint().z(), 0.4);
}

TEST(LaidSupports, OfOneHeightLieInAnyOrder) {
  const std::vector<Path> paths = withoutTravels(secondLayerWith(
      {supports({supportLine({10, 0}, {10, 5})}, 0.4), supports({supportLine({40, 0}, {40, 5})}, 0.4)}));
  ASSERT_EQ(paths.size(), 3U);
  EXPECT_EQ(paths[0].firstPoint().x(), 40.0);
}

TEST(LaidSupports, BeginLoopsWhereTheWayIsShortest) {
  FillPath loop;
  loop.is_closed = true;
  loop.points = test::rectangle(10, 20, 20, 30);  // from (10, 20)
  const std::vector<Path> paths = withoutTravels(secondLayerWith({supports({loop}, 0.4)}));
  ASSERT_EQ(paths.size(), 2U);
  // To and from (20, 20) it is 36.06 + 28.28 mm, to and from (10, 20) 44.72 + 22.36 mm, others are farther.
  EXPECT_EQ(paths[0].firstPoint(), Point3(20, 20, 0.4));
  EXPECT_EQ(paths[0].points.size(), 4U);
  EXPECT_TRUE(paths[0].is_closed);
}

TEST(LaidSupports, LeaveThePartAsItIs) {
  PlanSettings settings;
  const Toolpath without = test::plan(test::tee(), settings);
  settings.supports.use = true;
  const Toolpath with = test::plan(test::tee(), settings);
  ASSERT_EQ(with.layers.size(), without.layers.size());
  const auto isOfPart = [](const Path& path) { return kindOf(path.role) != RoleKind::BuildAid; };
  for (std::size_t l = 0; l < with.layers.size(); ++l) {
    const std::vector<Path> expected = withoutTravels(without.layers[l].paths);
    const std::vector<Path> paths = withoutTravels(with.layers[l].paths);
    const auto first = std::find_if(paths.begin(), paths.end(), isOfPart);
    const auto wanted = std::find_if(expected.begin(), expected.end(), isOfPart);
    ASSERT_EQ(paths.end() - first, expected.end() - wanted) << l;
    EXPECT_TRUE(std::equal(first, paths.end(), wanted, [](const Path& a, const Path& b) {
      return a.points == b.points;
    })) << l;
  }
}

}  // namespace
}  // namespace lamina
