// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/deposition/path_follower.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>

#include "lamina/base/random.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

Path openPath(const std::vector<Point3>& points) {
  Path path = test::straightPath(points.front(), points.back());
  path.points = points;
  return path;
}

Toolpath oneLayer(const std::vector<Point3>& points) { return {"part", {{0.2, 0.2, {openPath(points)}}}}; }

/// Lines of 20 mm side by side, 0.4 mm apart, on layers above each other.
Toolpath zigzags(int layers) {
  Toolpath toolpath{"zigzag", {}};
  for (int layer = 0; layer < layers; ++layer) {
    const double z = 0.2 * (layer + 1);
    std::vector<Point3> points;
    for (int line = 0; line < 20; ++line)
      for (const double x : {line % 2 == 0 ? 0.0 : 20.0, line % 2 == 0 ? 20.0 : 0.0})
        points.emplace_back(x, 0.4 * line, z);
    Path travel = test::straightPath(points.back(), points.front() + Point3(0, 0, 0.2));
    travel.role = PathRole::Travel;
    travel.bead = Bead{};
    toolpath.layers.push_back({z, 0.2, {openPath(points), travel}});
  }
  toolpath.layers.back().paths.pop_back();
  return toolpath;
}

/// Way along the toolpath up to a place [mm].
double wayTo(const PathFollower& follower) {
  double way = 0.0;
  const PathPosition& place = follower.place();
  for (std::size_t p = 0; p < follower.paths().size(); ++p) {
    const Path& path = *follower.paths()[p];
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const double length = (path.points[path.motionEnd(m)] - path.points[m]).norm();
      if (p == place.path && m == place.motion) return way + place.fraction * length;
      way += length;
    }
  }
  return way;
}

/// Positions along the whole toolpath, and the way up to each.
struct Report {
  Point3 tip;
  double way = 0.0;
};
std::vector<Report> reportsAlong(const Toolpath& toolpath, double spacing) {
  std::vector<Report> reports;
  double done = 0.0;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      for (std::size_t m = 0; m < path.motionCount(); ++m) {
        const Point3& start = path.points[m];
        const Point3 along = path.points[path.motionEnd(m)] - start;
        const int count = std::max(1, static_cast<int>(std::ceil(along.norm() / spacing)));
        for (int i = 0; i < count; ++i)
          reports.push_back({start + along * i / count, done + along.norm() * i / count});
        done += along.norm();
        reports.push_back({start + along, done});
      }
  return reports;
}

TEST(PathFollower, IsWhereDenseReportsAre) {
  const Toolpath toolpath = zigzags(3);
  PathFollower follower(toolpath, {});
  for (const Report& report : reportsAlong(toolpath, 0.3)) {
    follower.observe(report.tip);
    ASSERT_NEAR(wayTo(follower), report.way, 0.16);
  }
  EXPECT_TRUE(follower.isAtEnd());
}

TEST(PathFollower, StaysNearNoisyReportsAndNeverGoesBack) {
  const Toolpath toolpath = zigzags(2);
  PathFollower follower(toolpath, {});
  Random random(7);
  double before = 0.0;
  for (const Report& report : reportsAlong(toolpath, 0.1)) {
    const Point3 noise(random.normal(0.0, 0.03), random.normal(0.0, 0.03), random.normal(0.0, 0.01));
    follower.observe(report.tip + noise);
    const double way = wayTo(follower);
    ASSERT_GE(way, before);
    ASSERT_NEAR(way, report.way, 1.0);
    before = way;
  }
  EXPECT_TRUE(follower.isAtEnd());
}

TEST(PathFollower, KeepsItsBranchWhereThePathCrossesItself) {
  // A figure of eight, and back over its own start.
  const Toolpath toolpath =
      oneLayer({{0, 0, 1}, {10, 10, 1}, {10, 0, 1}, {0, 10, 1}, {0, 0, 1}, {10, 10, 1}, {12, 12, 1}});
  PathFollower follower(toolpath, {});
  for (const Report& report : reportsAlong(toolpath, 0.25)) {
    follower.observe(report.tip);
    ASSERT_NEAR(wayTo(follower), report.way, 0.16);
  }
  EXPECT_TRUE(follower.isAtEnd());
}

TEST(PathFollower, StrayReportsLeadNowhere) {
  const Toolpath toolpath = zigzags(3);
  PathFollower follower(toolpath, {});
  int count = 0;
  for (const Report& report : reportsAlong(toolpath, 0.5)) {
    // On the toolpath, a layer ahead.
    if (++count % 10 == 0 && report.tip.z() < 0.3) follower.observe(Point3(5, 6, 0.4));
    if (count % 7 == 0) follower.observe(Point3(500, 6, 0.4));
    if (count % 11 == 0) follower.observe(Point3::Constant(std::numeric_limits<double>::quiet_NaN()));
    follower.observe(report.tip);
    ASSERT_LE(wayTo(follower), report.way + 0.3 + 1e-9);
  }
  EXPECT_TRUE(follower.isAtEnd());
}

TEST(PathFollower, ComingDownOntoTheStartIsNotALaterLayer) {
  const Toolpath toolpath = zigzags(5);
  FollowingSettings far;
  far.look_ahead_mm = 1e5;
  PathFollower follower(toolpath, far);
  for (const double z : {5.0, 0.8, 0.8, 0.8, 0.6, 0.4, 0.2}) {
    follower.observe(Point3(0, 0, z));
    EXPECT_EQ(wayTo(follower), 0.0) << "at z = " << z;
  }
  follower.observe(Point3(1, 0, 0.2));
  EXPECT_NEAR(wayTo(follower), 1.0, 1e-9);
}

TEST(PathFollower, CatchesUpOnceReportsAreMissing) {
  const Toolpath toolpath = zigzags(2);
  PathFollower follower(toolpath, {});
  const auto reports = reportsAlong(toolpath, 0.5);
  for (std::size_t i = 0; i < reports.size(); ++i) {
    if (i > 100 && i < 300) continue;
    follower.observe(reports[i].tip);
    if (i >= 304) {
      ASSERT_NEAR(wayTo(follower), reports[i].way, 0.16) << "report " << i;
    }
  }
  EXPECT_TRUE(follower.isAtEnd());
}

TEST(PathFollower, FollowsReportsThatAreFarApartInLeaps) {
  const Toolpath toolpath = zigzags(6);
  PathFollower follower(toolpath, {});
  const auto reports = reportsAlong(toolpath, 0.5);
  for (std::size_t i = 0; i < reports.size(); i += 17) {
    follower.observe(reports[i].tip);
    ASSERT_LE(wayTo(follower), reports[i].way + 0.3 + 1e-9);
  }
  EXPECT_GT(wayTo(follower), 0.7 * reports.back().way);
}

TEST(PathFollower, EndsAtTheEndForAnyWay) {
  EXPECT_TRUE(rc::check([] {
    const auto count = *rc::gen::inRange(2, 30);
    std::vector<Point3> points;
    Random random(static_cast<std::uint64_t>(*rc::gen::inRange(0, 1000000)));
    for (int i = 0; i < count; ++i)
      points.emplace_back(random.uniform(0, 30), random.uniform(0, 30), random.uniform(0, 30));
    const Toolpath toolpath = oneLayer(points);
    PathFollower follower(toolpath, {});
    double before = 0.0;
    for (const Report& report : reportsAlong(toolpath, 0.2)) {
      follower.observe(report.tip);
      RC_ASSERT(wayTo(follower) >= before);
      before = wayTo(follower);
    }
    RC_ASSERT(follower.isAtEnd());
  }));
}

/// As a robot does that comes down to its start through the travels of layers to come.
TEST(PathFollower, IsNotLedAheadByTravelsBeforeItWasSeenOnABead) {
  Toolpath part;
  for (const double z : {1.0, 2.0}) {
    Path back = openPath({{20, 0, z}, {20, 0, z + 5.0}, {0, 0, z + 5.0}, {0, 0, z + 1.0}});
    back.role = PathRole::Travel;
    part.layers.push_back({z, 1.0, {openPath({{0, 0, z}, {20, 0, z}}), back}});
  }
  PathFollower follower(part, {});
  for (double z = 9.0; z >= 1.0; z -= 0.1) follower.observe({0, 0, z});
  EXPECT_EQ(follower.place().path, 0U);
  for (double x = 0.0; x <= 20.0; x += 0.1) follower.observe({x, 0, 1.0});
  for (double z = 1.0; z <= 4.0; z += 0.1) follower.observe({20, 0, z});
  EXPECT_EQ(follower.place().path, 1U) << "then they count";
}

}  // namespace
}  // namespace lamina
