// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "lamina/base/error.hpp"
#include "lamina/base/random.hpp"
#include "lamina/planning/runs/runs.hpp"

namespace lamina {
namespace {

constexpr double kLayerZ = 0.5;  // mm

Path walled(std::vector<Point3> points) {
  Path path;
  path.role = PathRole::OuterWall;
  path.points = std::move(points);
  path.bead = Bead{1.0, 0.5};
  path.feed_mm_s = 8.0;
  return path;
}

/// From 5 mm above to 5 mm above.
Path overTo(const Point3& from, const Point3& to) {
  Path path;
  path.role = PathRole::Travel;
  path.points = {from, from + Point3(0, 0, 5), to + Point3(0, 0, 5), to};
  path.feed_mm_s = 100.0;
  return path;
}

/// Against the clock from +x on, a corner every degree.
Path circleOf(double radius_mm) {
  std::vector<Point3> points;
  for (int i = 0; i < 360; ++i) {
    const double angle = M_PI * i / 180.0;
    points.emplace_back(radius_mm * std::cos(angle), radius_mm * std::sin(angle), kLayerZ);
  }
  Path path = walled(std::move(points));
  path.is_closed = true;
  return path;
}

Toolpath runsOnOneLayer(std::vector<Path> paths) {
  Toolpath toolpath;
  toolpath.layers = {{kLayerZ, 0.5, std::move(paths)}};
  return toolpath;
}

LeadSettings loopOf(double radius_mm) {
  LeadSettings lead;
  lead.in = lead.out = LeadShape::Loop;
  lead.radius_mm = radius_mm;
  return lead;
}

EntrySettings alongTheRun(double distance_mm) {
  EntrySettings entry;
  entry.distance_mm = distance_mm;
  entry.direction = EntryDirection::Tangent;
  return entry;
}

void expectCircle(const Path& lead, const Point3& centre, double radius_mm) {
  EXPECT_EQ(lead.points.size(), 73U);  // every 5 deg
  for (const Point3& point : lead.points) EXPECT_NEAR((point - centre).norm(), radius_mm, 1e-9);
}

TEST(LeadLoops, AreTangentCirclesOnTheFreeSideOfATube) {
  Path outer = circleOf(20.0);
  Path hole = circleOf(15.0);
  std::reverse(hole.points.begin() + 1, hole.points.end());
  Toolpath toolpath = runsOnOneLayer(
      {overTo({0, 0, 9}, outer.firstPoint()), outer, overTo(outer.firstPoint(), hole.firstPoint()), hole});
  const LeadCount count = addEnds(toolpath, loopOf(4.0), {}).leads;
  validate(toolpath);
  EXPECT_EQ(count.added, 4U);
  EXPECT_EQ(count.shortened + count.left_out, 0U);
  const auto& paths = toolpath.layers[0].paths;
  ASSERT_EQ(paths.size(), 8U);
  // Both rings start at +x with a first side that is half a degree askew: the centres are, too.
  const double askew = 0.5 * M_PI / 180.0;
  const Point3 out(std::cos(askew), std::sin(askew), 0.0);
  expectCircle(paths[1], outer.firstPoint() + 4.0 * out, 4.0);
  expectCircle(paths[3], outer.firstPoint() + 4.0 * Point3(out.x(), -out.y(), 0.0), 4.0);
  expectCircle(paths[5], hole.firstPoint() - 4.0 * Point3(out.x(), -out.y(), 0.0), 4.0);
  for (const std::size_t index : {1U, 3U, 5U, 7U}) {
    const Path& lead = paths[index];
    EXPECT_EQ(lead.role, PathRole::Travel);
    EXPECT_LT((lead.firstPoint() - lead.lastPoint()).norm(), 1e-9);
  }
  const Point3 arriving = (paths[1].points[72] - paths[1].points[71]).normalized();
  EXPECT_NEAR(arriving.dot((outer.points[1] - outer.points[0]).normalized()), std::cos(2.5 * M_PI / 180.0),
              1e-9);
  const Point3 leaving = (paths[3].points[1] - paths[3].points[0]).normalized();
  EXPECT_NEAR(leaving.dot((outer.points[0] - outer.points[359]).normalized()), std::cos(2.5 * M_PI / 180.0),
              1e-9);
}

/// A bead of 30 mm along x between walls as far to both sides.
Toolpath between(double walls_mm) {
  std::vector<Path> paths;
  for (const double y : {-walls_mm, walls_mm}) paths.push_back(walled({{-30, y, kLayerZ}, {60, y, kLayerZ}}));
  paths.push_back(walled({{0, 0, kLayerZ}, {30, 0, kLayerZ}}));
  std::vector<Path> all;
  for (Path& path : paths) {
    if (!all.empty()) all.push_back(overTo(all.back().lastPoint(), path.firstPoint()));
    all.push_back(std::move(path));
  }
  return runsOnOneLayer(std::move(all));
}

TEST(LeadLoops, AreSmallerWhereThereIsLessRoom) {
  // Beads of 1 x 0.5 mm are packed 0.893 mm apart: 5 mm leave 4.107 mm for a circle, whose radius is one of
  // 0.25 mm, 0.5 mm, ... 4 mm.
  Toolpath toolpath = between(5.0);
  const LeadCount count = addEnds(toolpath, loopOf(4.0), {}).leads;
  validate(toolpath);
  EXPECT_EQ(count.added, 6U);
  EXPECT_EQ(count.shortened, 2U);
  const auto& paths = toolpath.layers[0].paths;
  const auto run = std::find_if(paths.begin(), paths.end(), [](const Path& path) {
    return path.role == PathRole::OuterWall && path.firstPoint().y() == 0.0;
  });
  double greatest = 0.0;
  for (const Point3& point : (run - 1)->points) greatest = std::max(greatest, std::abs(point.y()));
  EXPECT_NEAR(greatest, 4.0, 1e-9);
  EXPECT_NEAR(length(*(run - 1)), 144.0 * 2.0 * std::sin(M_PI / 72.0), 1e-9);
}

TEST(LeadLoops, AreLeftOutWithoutRoom) {
  Toolpath toolpath = between(1.2);
  const LeadCount count = addEnds(toolpath, loopOf(4.0), {}).leads;
  EXPECT_EQ(count.left_out, 2U);
  EXPECT_EQ(count.added, 4U);
}

TEST(LeadLoops, RiseAsAHelix) {
  Toolpath toolpath = runsOnOneLayer({walled({{0, 0, kLayerZ}, {30, 0, kLayerZ}})});
  LeadSettings lead = loopOf(3.0);
  lead.rise_deg = 10.0;
  addEnds(toolpath, lead, {});
  validate(toolpath);
  const Path& in = toolpath.layers[0].paths[0];
  EXPECT_LT((in.firstPoint() - Point3(0, 0, kLayerZ + 6.0 * M_PI * std::tan(10.0 * M_PI / 180.0))).norm(),
            1e-9);
  EXPECT_LT((in.lastPoint() - Point3(0, 0, kLayerZ)).norm(), 1e-9);
}

TEST(LeadLoops, ThatLayBeadsAreRefusedByName) {
  BeadRunSettings settings;
  settings.lead.out = LeadShape::Loop;
  EXPECT_NO_THROW(requireConsistent(settings));
  settings.lead.deposit = LeadDeposit::Bead;
  try {
    requireConsistent(settings);
    FAIL();
  } catch (const InvalidConfig& error) {
    EXPECT_NE(std::string(error.what()).find("lead.out is 'loop' with leads that lay a bead; expected"),
              std::string::npos)
        << error.what();
  }
}

TEST(TangentEntries, GoStraightOnFromTheRun) {
  const Point3 start(0, 0, kLayerZ);
  const Point3 end(30, 0, kLayerZ);
  Toolpath toolpath =
      runsOnOneLayer({overTo({0, 20, kLayerZ}, start), walled({start, end}), overTo(end, {9, 9, kLayerZ})});
  const EndCount count = addEnds(toolpath, {}, alongTheRun(12.0));
  validate(toolpath);
  EXPECT_EQ(count.entries, 2U);
  EXPECT_EQ(count.without_tangent, 0U);
  const auto& paths = toolpath.layers[0].paths;
  ASSERT_EQ(paths.size(), 5U);
  EXPECT_LT((paths[1].points[0] - Point3(-12, 0, kLayerZ)).norm(), 1e-9);
  EXPECT_LT((paths[1].points[1] - start).norm(), 1e-9);
  EXPECT_LT((paths[3].points[1] - Point3(42, 0, kLayerZ)).norm(), 1e-9);
  // Travels come down where the entry begins, and rise where it ends.
  EXPECT_LT((paths[0].points[2] - Point3(-12, 0, kLayerZ + 5.0)).norm(), 1e-9);
  EXPECT_LT((paths[4].points[1] - Point3(42, 0, kLayerZ + 5.0)).norm(), 1e-9);
}

TEST(TangentEntries, GoOnFromTheLead) {
  Toolpath toolpath = runsOnOneLayer({walled({{0, 0, kLayerZ}, {30, 0, kLayerZ}})});
  LeadSettings lead;
  lead.in = LeadShape::Arc;
  lead.radius_mm = 5.0;
  lead.sweep_deg = 90.0;
  const EndCount count = addEnds(toolpath, lead, alongTheRun(8.0));
  validate(toolpath);
  EXPECT_EQ(count.without_tangent, 0U);
  const auto& paths = toolpath.layers[0].paths;
  // The arc comes from 5 mm behind and 5 mm aside, where it goes across the bead; its last chord is 2.5 deg
  // askew.
  const Point3 far = paths[0].points[0] - paths[1].points[0];
  EXPECT_NEAR(far.norm(), 8.0, 1e-9);
  EXPECT_NEAR(std::abs(far.y()), 8.0 * std::cos(2.5 * M_PI / 180.0), 1e-9);
  EXPECT_NEAR(std::abs(paths[1].points[0].y()), 5.0, 1e-9);
}

TEST(TangentEntries, GoAlongTheToolAxisWhereTheRunIsInTheWay) {
  // A square that starts amid a side: its tangent is the side.
  Path square = walled(
      {{20, 0, kLayerZ}, {20, 20, kLayerZ}, {-20, 20, kLayerZ}, {-20, -20, kLayerZ}, {20, -20, kLayerZ}});
  square.is_closed = true;
  Toolpath toolpath = runsOnOneLayer({square});
  const EndCount count = addEnds(toolpath, {}, alongTheRun(12.0));
  EXPECT_EQ(count.without_tangent, 2U);
  EXPECT_LT((toolpath.layers[0].paths[0].points[0] - Point3(20, 0, kLayerZ + 12.0)).norm(), 1e-9);
}

/// Of a point from the motions of a path.
double offPath(const Path& path, const Point3& point) {
  double least = 1e9;
  for (std::size_t m = 0; m < path.motionCount(); ++m) {
    const Point3& from = path.points[m];
    const Point3 way = path.points[path.motionEnd(m)] - from;
    const double share = std::clamp((point - from).dot(way) / way.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (from + share * way - point).norm());
  }
  return least;
}

TEST(LeadLoops, KeepOffWhatIsDepositedWhereverItLies) {
  EXPECT_TRUE(rc::check("of all other runs of a layer, but where these meet the run already", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    std::vector<Path> walls;
    for (std::size_t count = 2 + random.below(4); count > 0; --count) {
      std::vector<Point3> points{{random.uniform(-20, 20), random.uniform(-20, 20), kLayerZ}};
      for (std::size_t corners = 1 + random.below(3); corners > 0; --corners)
        points.push_back(points.back() + Point3(random.uniform(3, 9), random.uniform(-9, 9), 0.0));
      walls.push_back(walled(points));
    }
    std::vector<Path> paths;
    for (const Path& wall : walls) {
      if (!paths.empty()) paths.push_back(overTo(paths.back().lastPoint(), wall.firstPoint()));
      paths.push_back(wall);
    }
    Toolpath toolpath = runsOnOneLayer(paths);
    const double radius_mm = random.uniform(0.5, 6.0);
    addEnds(toolpath, loopOf(radius_mm), {});
    validate(toolpath);
    const auto& made = toolpath.layers[0].paths;
    const double need_mm = planWidth({1.0, 0.5}) - 0.05;  // what chords of 5 deg and samples leave
    for (const Path& lead : made) {
      if (lead.points.size() != 73) continue;
      RC_ASSERT((lead.firstPoint() - lead.lastPoint()).norm() < 1e-9);
      RC_ASSERT(length(lead) <= 2.0 * M_PI * radius_mm + 1e-9);
      for (const Path& wall : walls) {
        const double begun_mm = offPath(wall, lead.firstPoint());
        if (begun_mm < 1e-9) continue;  // its own
        for (const Point3& point : lead.points)
          RC_ASSERT(offPath(wall, point) >= std::min(need_mm, begun_mm - 0.05));
      }
    }
  }));
}

}  // namespace
}  // namespace lamina
