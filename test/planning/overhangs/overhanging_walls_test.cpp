// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Walls that stand beyond the layer below.
#include "lamina/planning/overhangs/overhanging_walls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/error.hpp"
#include "lamina/base/parallel.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::plan;
using test::rectangle;

constexpr double kWallFeed = 30.0;  // mm/s, of outer walls

/// Share of a bead of 0.4 x 0.2 mm on a wall that leans.
double leanShare(double lean_deg) { return overhangShare(0.2 * std::tan(lean_deg * M_PI / 180.0), 0.4); }

TEST(OverhangShare, FollowsTheLeanOfTheWall) {
  EXPECT_NEAR(leanShare(30), 0.289, 5e-4);
  EXPECT_NEAR(leanShare(45), 0.5, 1e-12);
  EXPECT_NEAR(leanShare(60), 0.866, 5e-4);
  EXPECT_EQ(leanShare(75), 1.0);
  EXPECT_EQ(overhangShare(-0.1, 0.4), 0.0);
  EXPECT_EQ(overhangShare(0.1, 0.0), 0.0);
}

TEST(OverhangFeedFactor, IsLinearBetweenEntries) {
  const OverhangingWallSettings settings;
  EXPECT_EQ(overhangFeedFactor(0.2, settings), 1.0);
  EXPECT_NEAR(overhangFeedFactor(leanShare(30), settings), 0.954, 1e-3);
  EXPECT_NEAR(overhangFeedFactor(leanShare(45), settings), 0.7, 1e-12);
  EXPECT_NEAR(overhangFeedFactor(leanShare(60), settings), 0.430, 1e-3);
  EXPECT_NEAR(overhangFeedFactor(1.0, settings), 0.35, 1e-12);
  EXPECT_EQ(overhangFlowFactor(0.6, settings), 1.0);
}

TEST(OverhangingWallSettings, AreRefusedOutOfOrder) {
  const auto refused = [](const auto& change) {
    OverhangingWallSettings settings;
    change(settings);
    EXPECT_THROW(requireConsistent(settings), InvalidConfig);
  };
  EXPECT_NO_THROW(requireConsistent(OverhangingWallSettings()));
  refused([](OverhangingWallSettings& s) { s.shares = {0.25, 0.2, 0.75, 1.0}; });
  refused([](OverhangingWallSettings& s) { s.shares = {0.25, 0.5, 0.75, 1.1}; });
  refused([](OverhangingWallSettings& s) { s.shares = {}; });
  refused([](OverhangingWallSettings& s) { s.feed_factors[2] = 0.0; });
  refused([](OverhangingWallSettings& s) { s.flow_factors.pop_back(); });
}

PlanSettings hollowPart() {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.infill.density = 0.0;
  settings.overhangs.is_used = true;
  return settings;
}

/// A cone that grows upwards.
std::vector<Layer> leaningCone(double lean_deg) {
  const double step = 0.2 * std::tan(lean_deg * M_PI / 180.0);
  return test::layersOf(
      6, [step](int l) { return std::vector<Polygon>{test::circle(Point2::Zero(), 20.0 + step * l, 720)}; });
}

TEST(OverhangingWalls, AreSlowedDownByTheirShare) {
  const double factors[][2] = {{20, 1.0}, {30, 0.954}, {45, 0.7}, {60, 0.430}, {75, 0.35}};
  for (const auto& [lean_deg, factor] : factors) {
    const Toolpath toolpath = plan(leaningCone(lean_deg), hollowPart());
    for (std::size_t l = 1; l < 6; ++l) {
      std::size_t motions = 0;
      for (const Path& path : toolpath.layers[l].paths) {
        if (path.role != PathRole::OuterWall) continue;
        for (std::size_t i = 0; i < path.points.size(); ++i, ++motions)
          ASSERT_NEAR(path.feed_mm_s.at(i), factor * kWallFeed, 0.01 * kWallFeed) << lean_deg << " deg";
      }
      EXPECT_GT(motions, 100U);
    }
  }
}

TEST(OverhangingWalls, KeepTheirLineAndVolume) {
  PlanSettings without = hollowPart();
  without.overhangs.is_used = false;
  const auto layers = leaningCone(60.0);
  const Toolpath slowed = plan(layers, hollowPart());
  const Toolpath plain = plan(layers, without);
  EXPECT_NEAR(totals(slowed).deposited_mm3, totals(plain).deposited_mm3, 1e-6);
  EXPECT_NEAR(totals(slowed).deposition_mm, totals(plain).deposition_mm, 1e-6);
  for (const Path& path : slowed.layers[0].paths)
    EXPECT_TRUE(path.feed_mm_s.isCommon()) << "nothing hangs over the bed";
}

/// A block whose upper half is wider on one side.
std::vector<Layer> cornice(double beyond_mm) {
  return test::layersOf(6, [beyond_mm](int l) {
    return std::vector<Polygon>{rectangle(0, 0, l < 3 ? 20.0 : 20.0 + beyond_mm, 20)};
  });
}

TEST(OverhangingWalls, AreDividedWhereTheShareChanges) {
  const Toolpath toolpath = plan(cornice(0.2), hollowPart());  // half a bead
  double slow = 0.0;
  for (const Path& path : toolpath.layers[3].paths) {
    if (path.role != PathRole::OuterWall) continue;
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const std::size_t end = path.motionEnd(m);
      if (path.feed_mm_s.at(end) < 0.8 * kWallFeed) slow += (path.points[end] - path.points[m]).norm();
    }
  }
  // That side, 19.6 mm, and on the two beside it less than a bead.
  EXPECT_GT(slow, 19.6 - 1e-6);
  EXPECT_LT(slow, 19.6 + 0.8);
  for (const Path& path : toolpath.layers[4].paths) EXPECT_TRUE(path.feed_mm_s.isCommon());
}

TEST(OverhangingWalls, AreNeverSlowerThanTheLeastFeed) {
  PlanSettings settings = hollowPart();
  settings.overhangs.least_feed_mm_s = 14.0;
  const auto slowest = [&] {
    double feed_mm_s = 1e9;
    const Toolpath toolpath = plan(leaningCone(75.0), settings);
    for (const Path& path : toolpath.layers[3].paths)
      for (const double feed : path.feed_mm_s.values()) feed_mm_s = std::min(feed_mm_s, feed);
    return feed_mm_s;
  };
  EXPECT_GE(slowest(), 14.0 - 1e-9);
  settings.overhangs.least_feed_mm_s = 0.0;
  EXPECT_LT(slowest(), 14.0);
}

TEST(OverhangingWalls, TakeTheirFlow) {
  PlanSettings settings = hollowPart();
  settings.overhangs.flow_factors = {1.0, 1.1, 1.2, 1.3};
  const auto layers = leaningCone(75.0);
  const Toolpath wider = plan(layers, settings);
  const Toolpath plain = plan(layers, hollowPart());
  const auto volume = [](const Toolpath& toolpath) {
    double sum = 0.0;
    for (const Path& path : toolpath.layers[2].paths)
      if (path.role == PathRole::OuterWall) sum += depositedVolume(path);
    return sum;
  };
  EXPECT_NEAR(volume(wider) / volume(plain), 1.3, 1e-3);
}

TEST(OverhangingWalls, RunTheOtherWayRoundInEverySecondLayer) {
  PlanSettings settings = hollowPart();
  settings.overhangs.reverses = true;
  const Toolpath toolpath = plan(leaningCone(60.0), settings);
  const auto area = [](const ToolpathLayer& layer) {
    Polygon loop;
    for (const Path& path : layer.paths)
      if (path.role == PathRole::OuterWall)
        for (const Point3& point : path.points) loop.push_back(point.head<2>());
    return signedArea(loop);
  };
  for (std::size_t l = 1; l < 5; ++l)
    EXPECT_LT(area(toolpath.layers[l]) * area(toolpath.layers[l + 1]), 0.0) << l;
}

TEST(OverhangingWalls, AreTheSameForAnyNumberOfThreads) {
  std::string id;
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);
    const std::string now = toolpathId(plan(leaningCone(60.0), hollowPart()));
    EXPECT_TRUE(id.empty() || now == id);
    id = now;
  }
}

TEST(OverhangingWalls, StandOnTheBedInInclinedLayers) {
  // Layers at 45 deg, cut in their middle: the outermost wall of each has nothing but the bed below.
  std::vector<Layer> layers;
  for (int l = 0; l < 6; ++l) {
    const double y = -0.2 * l - 0.1;
    layers.push_back({{0.2 * l, 0.2 * (l + 1)}, {{rectangle(0, y, 20, 20)}, {}}});
  }
  // The bed is where y + z is 0.
  const Point3 up(0.0, std::sqrt(0.5), std::sqrt(0.5));
  NoProgress nobody;
  const auto slowed = [&](double level_mm) {
    std::size_t count = 0;
    const LayerIncline incline{{up, level_mm}, Eigen::Quaterniond::Identity()};
    PlanSettings settings = hollowPart();
    settings.anchoring.strategy = Anchoring::None;
    const Toolpath toolpath = planPart("part", layers, settings, incline, nobody).toolpath;
    for (std::size_t l = 1; l < toolpath.layers.size(); ++l)
      for (const Path& path : toolpath.layers[l].paths)
        if (path.role == PathRole::OuterWall && !path.feed_mm_s.isCommon()) ++count;
    return count;
  };
  EXPECT_EQ(slowed(0.0), 0U);
  EXPECT_GE(slowed(-50.0), 5U) << "the bed far below";
}

}  // namespace
}  // namespace lamina
