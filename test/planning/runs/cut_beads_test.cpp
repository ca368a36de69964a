// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/runs/cut_beads.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <limits>
#include <set>
#include <tuple>

#include "lamina/base/angle.hpp"
#include "lamina/base/random.hpp"
#include "planning/nozzle_frame.hpp"
#include "planning/travel/space_travel.hpp"
#include "support/random_toolpath.hpp"
#include "support/toolpaths.hpp"

namespace lamina {
namespace {

constexpr double kOffMm = 1.0;

CutBeads cutIn(const Toolpath& toolpath, const HinderedWaypoints& hindered) {
  CutBeads cut =
      cutBeads(toolpath, hindered,
               spaceTravels(toolpath.layers, {}, -std::numeric_limits<double>::infinity()), kOffMm);
  validate(cut.toolpath);
  return cut;
}

/// Five motions of 2 mm along x.
Path fiveMotions() {
  Path path = test::straightPath({0, 0, 0.2}, {10, 0, 0.2});
  path.points = {{0, 0, 0.2}, {2, 0, 0.2}, {4, 0, 0.2}, {6, 0, 0.2}, {8, 0, 0.2}, {10, 0, 0.2}};
  return path;
}

Toolpath cuttable(const std::vector<Path>& paths) { return {"cut", {{0.2, 0.2, paths}}}; }

std::vector<Path> beadsOf(const Toolpath& toolpath) {
  std::vector<Path> beads;
  for (const ToolpathLayer& layer : toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role != PathRole::Travel) beads.push_back(path);
  return beads;
}

TEST(CutBeads, LeavesOutTheMotionsToAndFromAShutWaypoint) {
  HinderedWaypoints hindered;
  hindered.shut = {{0, 0, 2}};
  const CutBeads cut = cutIn(cuttable({fiveMotions()}), hindered);
  ASSERT_EQ(cut.toolpath.layers[0].paths.size(), 3U);
  EXPECT_EQ(cut.toolpath.layers[0].paths[1].role, PathRole::Travel);
  const std::vector<Path> beads = beadsOf(cut.toolpath);
  EXPECT_EQ(beads[0].points, (std::vector<Point3>{{0, 0, 0.2}, {2, 0, 0.2}}));
  EXPECT_EQ(beads[1].points, (std::vector<Point3>{{6, 0, 0.2}, {8, 0, 0.2}, {10, 0, 0.2}}));
  EXPECT_NEAR(cut.left_out_mm3, 4.0 * crossSection({0.4, 0.2}), 1e-12);
  EXPECT_EQ(cut.turns, 0U);
}

TEST(CutBeads, LeavesOutWhatIsShorterThanItsBeadIsWide) {
  Path path = fiveMotions();
  path.points = {{0, 0, 0.2}, {2, 0, 0.2}, {4, 0, 0.2}, {4.3, 0, 0.2}, {6, 0, 0.2}, {10, 0, 0.2}};
  HinderedWaypoints hindered;
  hindered.shut = {{0, 0, 1}, {0, 0, 4}};
  const CutBeads cut = cutIn(cuttable({path}), hindered);
  EXPECT_TRUE(beadsOf(cut.toolpath).empty());
  EXPECT_NEAR(cut.left_out_mm3, 10.0 * crossSection({0.4, 0.2}), 1e-12);
}

/// The square ends where it began: what is left is one line of three sides less two motions.
TEST(CutBeads, AClosedPathThatIsCutGoesOnWhereItBegan) {
  Path square = test::twoLayers().layers[0].paths[0];
  HinderedWaypoints hindered;
  hindered.shut = {{0, 0, 2}};
  const std::vector<Path> beads = beadsOf(cutIn(cuttable({square}), hindered).toolpath);
  ASSERT_EQ(beads.size(), 1U);
  EXPECT_FALSE(beads[0].is_closed);
  EXPECT_EQ(beads[0].points, (std::vector<Point3>{{0, 10, 0.2}, {0, 0, 0.2}, {10, 0, 0.2}}));
}

TEST(CutBeads, TurnsOffTheBeadBeforeATurningWaypoint) {
  Path path = fiveMotions();
  const auto leaning = [](double deg) {
    return nozzleAgainst({std::sin(toRadians(deg)), 0.0, std::cos(toRadians(deg))});
  };
  path.orientation = AlongPath<Eigen::Quaterniond>(
      {leaning(0), leaning(0), leaning(0), leaning(20), leaning(20), leaning(20)});
  HinderedWaypoints hindered;
  hindered.turning = {{0, 0, 3}};
  const CutBeads cut = cutIn(cuttable({path}), hindered);
  ASSERT_EQ(cut.toolpath.layers[0].paths.size(), 3U);
  EXPECT_EQ(cut.turns, 1U);
  EXPECT_NEAR(cut.left_out_mm3, 0.0, 1e-12);
  const Path& travel = cut.toolpath.layers[0].paths[1];
  EXPECT_TRUE(travel.points[1].isApprox(Point3(4, 0, 1.2)));
  EXPECT_NEAR((travel.points[2] - travel.points[3]).norm(), kOffMm, 1e-12);
  EXPECT_NEAR(travel.orientation.at(3).angularDistance(leaning(20)), 0.0, 1e-9);
  const Path& second = cut.toolpath.layers[0].paths[2];
  EXPECT_EQ(second.points.front(), Point3(4, 0, 0.2));
  EXPECT_NEAR(second.orientation.at(0).angularDistance(leaning(20)), 0.0, 1e-9);
}

TEST(CutBeads, ALowTravelRisesToThreeTimesItsHeight) {
  Path travel = test::straightPath({10, 0, 0.2}, {10, 5, 0.2});
  travel.role = PathRole::Travel;
  travel.bead = Bead{};
  HinderedWaypoints hindered;
  hindered.low = {{0, 1, 0}};
  Toolpath toolpath = cuttable({fiveMotions(), travel, test::straightPath({10, 5, 0.2}, {0, 5, 0.2})});
  for (const double rise_mm : {kOffMm, 3.0 * kOffMm, 9.0 * kOffMm}) {
    toolpath = cutIn(toolpath, hindered).toolpath;
    ASSERT_EQ(toolpath.layers[0].paths.size(), 3U);
    EXPECT_NEAR(rise(toolpath.layers[0].paths[1]), rise_mm, 1e-12);
  }
}

TEST(CutBeads, EventsComeWithTheirMotions) {
  Path path = fiveMotions();
  path.events = {{0, Dwell{1.0}}, {1, Dwell{2.0}}, {4, Dwell{3.0}}, {5, Dwell{4.0}}};
  HinderedWaypoints hindered;
  hindered.shut = {{0, 0, 2}};
  const std::vector<Path> beads = beadsOf(cutIn(cuttable({path}), hindered).toolpath);
  ASSERT_EQ(beads.size(), 2U);
  EXPECT_EQ(beads[0].events.size(), 1U);
  EXPECT_EQ(dwellBefore(beads[0].events, 0), 1.0);
  EXPECT_EQ(dwellBefore(beads[1].events, 1), 3.0);
  EXPECT_EQ(dwellBefore(beads[1].events, 2), 4.0);
}

TEST(CutBeads, WithoutHindranceAToolpathStays) {
  EXPECT_TRUE(rc::check("any toolpath", [](std::uint64_t seed) {
    const Toolpath toolpath = test::randomToolpath(seed);
    RC_ASSERT(toolpathId(cutIn(toolpath, {}).toolpath) == toolpathId(toolpath));
  }));
}

using Segment = std::tuple<double, double, double, double>;

std::multiset<Segment> segmentsOf(const Toolpath& toolpath, const HinderedWaypoints& without) {
  std::multiset<Segment> segments;
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (std::size_t p = 0; p < toolpath.layers[l].paths.size(); ++p) {
      const Path& path = toolpath.layers[l].paths[p];
      for (std::size_t m = 0; m < path.motionCount() && path.role != PathRole::Travel; ++m) {
        const std::size_t end = path.motionEnd(m);
        if (without.shut.count({l, p, m}) != 0 || without.shut.count({l, p, end}) != 0) continue;
        if (without.off.count({l, p, end}) != 0) continue;
        const Point3& a = path.points[m];
        const Point3& b = path.points[end];
        segments.insert({a.x(), a.y(), b.x(), b.y()});
      }
    }
  return segments;
}

/// Any waypoints of beads; now and then one that turns or a travel that is low.
HinderedWaypoints hinderedAtRandom(const Toolpath& toolpath, Random& random) {
  HinderedWaypoints hindered;
  for (std::size_t l = 0; l < toolpath.layers.size(); ++l)
    for (std::size_t p = 0; p < toolpath.layers[l].paths.size(); ++p) {
      const Path& path = toolpath.layers[l].paths[p];
      for (std::size_t w = 0; w < path.points.size(); ++w) {
        const auto drawn = random.below(8);
        if (path.role == PathRole::Travel && w == 0 && drawn == 0) hindered.low.insert({l, p, 0});
        if (path.role != PathRole::Travel && drawn == 1) hindered.shut.insert({l, p, w});
        if (path.role != PathRole::Travel && drawn == 2) hindered.turning.insert({l, p, w});
        if (path.role != PathRole::Travel && drawn == 3) hindered.off.insert({l, p, w});
      }
    }
  return hindered;
}

TEST(CutBeads, WhatIsDepositedIsWhatNothingHinders) {
  EXPECT_TRUE(rc::check("any toolpath and waypoints", [](std::uint64_t seed) {
    const Toolpath toolpath = test::randomToolpath(seed);
    Random random(seed + 1);
    const HinderedWaypoints hindered = hinderedAtRandom(toolpath, random);
    const CutBeads cut = cutIn(toolpath, hindered);
    const std::multiset<Segment> expected = segmentsOf(toolpath, hindered);
    const std::multiset<Segment> deposited = segmentsOf(cut.toolpath, {});
    RC_ASSERT(std::includes(expected.begin(), expected.end(), deposited.begin(), deposited.end()));
    RC_ASSERT(std::abs(totals(toolpath).deposited_mm3 - totals(cut.toolpath).deposited_mm3 -
                       cut.left_out_mm3) < 1e-9);
  }));
}

}  // namespace
}  // namespace lamina
