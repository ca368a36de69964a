// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Threads over gaps, as they are planned.
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <cmath>
#include <set>

#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "planning/bridges/bridge_threads.hpp"
#include "planning/bridges/bridged_areas.hpp"
#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::rectangle;

const double kThreadPitch = 0.4 - (1.0 - 0.25 * M_PI) * 0.2;
const double kTwoWalls = 0.2 + 1.5 * kThreadPitch;

PlanSettings spanning() {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.infill.density = 0.15;
  settings.skins.top_layers = settings.skins.bottom_layers = 4;
  settings.bridges.is_used = true;
  return settings;
}

Plan plannedPart(const std::vector<Layer>& layers, const PlanSettings& settings) {
  NoProgress nobody;
  Plan plan = planPart("part", layers, settings, nobody);
  validate(plan.toolpath);
  return plan;
}

/// Pillars of 10 x 20 mm, 20 mm apart, for five layers; a plate of 40 x 20 mm over both.
std::vector<Layer> bridge() {
  return test::layersOf(15, [](int l) {
    if (l >= 5) return std::vector<Polygon>{rectangle(0, 0, 40, 20)};
    return std::vector<Polygon>{rectangle(0, 0, 10, 20), rectangle(30, 0, 40, 20)};
  });
}

std::vector<Path> threadsOf(const ToolpathLayer& layer) {
  std::vector<Path> threads;
  for (const Path& path : layer.paths)
    if (path.role == PathRole::Bridge) threads.push_back(path);
  return threads;
}

/// Straight stretches of threads; a joint between neighbours is no longer than a millimetre.
std::vector<std::array<Point2, 2>> spansOf(const std::vector<Path>& threads) {
  std::vector<std::array<Point2, 2>> spans;
  for (const Path& path : threads)
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const Point2 from = path.points[m].head<2>();
      const Point2 to = path.points[path.motionEnd(m)].head<2>();
      if ((to - from).norm() > 1.0) spans.push_back({from, to});
    }
  return spans;
}

double threadVolume(const std::vector<Path>& paths) {
  double sum = 0.0;
  for (const Path& path : paths) sum += depositedVolume(path);
  return sum;
}

TEST(Bridges, SpanFromPillarToPillar) {
  const Plan plan = plannedPart(bridge(), spanning());
  EXPECT_EQ(plan.bridging.bridges, 1U);
  EXPECT_EQ(plan.bridging.unheld, 0U);
  EXPECT_EQ(plan.bridging.too_long, 0U);
  EXPECT_NEAR(plan.bridging.longest_mm, 20.0, 1e-3);
  const std::vector<Path> threads = threadsOf(plan.toolpath.layers[5]);
  const auto spans = spansOf(threads);
  EXPECT_GE(spans.size(), 51U);
  EXPECT_LE(spans.size(), 52U);
  const double volume = (20.0 + 2.0 * 1.0) * (20.0 - 2.0 * kTwoWalls) * 0.2;
  EXPECT_NEAR(threadVolume(threads), volume, 0.01 * volume);
  // An anchor of 1 mm, less half a pitch of 0.357 mm where threads are joined.
  for (const auto& [from, to] : spans) {
    EXPECT_NEAR(from.y(), to.y(), 1e-9) << "along x exactly";
    EXPECT_LE(std::min(from.x(), to.x()), 10.0 - 0.7);
    EXPECT_GE(std::max(from.x(), to.x()), 30.0 + 0.7);
  }
  for (const Path& thread : threads)
    for (std::size_t i = 1; i < thread.points.size(); ++i) EXPECT_EQ(thread.feed_mm_s.at(i), 20.0);
  for (std::size_t l = 0; l < 15; ++l) EXPECT_EQ(threadsOf(plan.toolpath.layers[l]).empty(), l != 5) << l;
}

TEST(Bridges, JoinNeighboursWhereTheyAreHeld) {
  const std::vector<Path> threads = threadsOf(plannedPart(bridge(), spanning()).toolpath.layers[5]);
  ASSERT_EQ(threads.size(), 1U) << "one run over the gap";
  for (const Point3& point : threads[0].points)
    EXPECT_TRUE(point.x() < 10.0 - 0.7 || point.x() > 30.0 + 0.7) << "turns on a pillar: " << point.x();
}

TEST(Bridges, JoinNoneWhoseEndsAreNotHeld) {
  // From ledges of 0.3 mm: no room for half a pitch behind a joint.
  const Regions below = unite({rectangle(0, 0, 5, 10), rectangle(11, 0, 16, 10)});
  const Regions inside = unite({rectangle(4.7, 1, 11.3, 9)});
  const auto threads = bridgeThreads({rectangle(5, 1, 11, 9), {}}, below, inside, {0.0, kThreadPitch, 1.0});
  EXPECT_EQ(threads.size(), 22U) << "8 mm of 0.364 mm";
  for (const FillPath& thread : threads) EXPECT_EQ(thread.points.size(), 2U);
}

TEST(Bridges, JoinNoneWhoseEndsLieApart) {
  // The right pillar recedes by 2 mm in the middle.
  const Regions below = unite({rectangle(0, 0, 5, 10), rectangle(11, 0, 20, 5), rectangle(13, 5, 20, 10)});
  const Regions inside = unite({rectangle(1, 1, 19, 9)});
  const Region piece{{{5, 1}, {11, 1}, {11, 5}, {13, 5}, {13, 9}, {5, 9}}, {}};
  const auto runs = bridgeThreads(piece, below, inside, {0.0, kThreadPitch, 1.0});
  // Eleven threads on either side: the last of the lower ones goes to the right, and cannot go on there.
  ASSERT_EQ(runs.size(), 2U);
  for (const FillPath& run : runs) EXPECT_EQ(run.points.size(), 22U);
  double length_mm = 0.0;
  for (const FillPath& run : runs) length_mm += length(run.points);
  // Eleven of 8 mm and eleven of 10 mm: joints are as long as what they cut off.
  EXPECT_NEAR(length_mm, 11 * 8.0 + 11 * 10.0, 1e-3);
}

TEST(Bridges, FillTheirLayerOnce) {
  const ToolpathLayer layer = plannedPart(bridge(), spanning()).toolpath.layers[5];
  double solid = 0.0;
  for (const Path& path : layer.paths)
    if (path.role == PathRole::Bridge || path.role == PathRole::Skin || path.role == PathRole::BottomSkin)
      solid += depositedVolume(path);
  // The plate's skin and what anchors it, no more than the area within the walls and no less than the gap.
  EXPECT_LT(solid, 1.01 * (40.0 - 2.0 * kTwoWalls) * (20.0 - 2.0 * kTwoWalls) * 0.2);
  EXPECT_GT(solid, 0.99 * 22.0 * (20.0 - 2.0 * kTwoWalls) * 0.2);
}

TEST(Bridges, LetWallsBesideThemGoAtTheirFeed) {
  const ToolpathLayer layer = plannedPart(bridge(), spanning()).toolpath.layers[5];
  std::size_t walls = 0;
  for (const Path& path : layer.paths) {
    if (kindOf(path.role) != RoleKind::Wall) continue;
    double slow = 0.0;
    for (std::size_t m = 0; m < path.motionCount(); ++m) {
      const std::size_t end = path.motionEnd(m);
      if (path.feed_mm_s.at(end) == 20.0) slow += (path.points[end] - path.points[m]).norm();
    }
    // Both long sides, 20 mm each, less where the bead's edge still touches the pillar.
    EXPECT_NEAR(slow, 40.0, 2.5) << toString(path.role);
    ++walls;
  }
  EXPECT_EQ(walls, 2U);
}

TEST(Bridges, AreTheSameUnderASolidInfill) {
  PlanSettings settings = spanning();
  settings.infill.density = 1.0;
  settings.skins = SkinSettings{};
  const Plan plan = plannedPart(bridge(), settings);
  const double volume = 22.0 * (20.0 - 2.0 * kTwoWalls) * 0.2;
  EXPECT_NEAR(threadVolume(threadsOf(plan.toolpath.layers[5])), volume, 0.01 * volume);
  double all = 0.0;
  for (const Path& path : plan.toolpath.layers[5].paths)
    if (kindOf(path.role) == RoleKind::Infill) all += depositedVolume(path);
  const double inside = (40.0 - 2.0 * kTwoWalls) * (20.0 - 2.0 * kTwoWalls) * 0.2;
  EXPECT_NEAR(all, inside, 0.01 * inside);
}

/// Their runs go on along the rim; threads over the gap would end there.
TEST(Bridges, LeaveTheRimToFillsThatLayItThemselves) {
  PlanSettings settings = spanning();
  settings.infill.density = 1.0;
  settings.skins = SkinSettings{};
  settings.walls.count = 0;
  for (const char* const strategy : {"spiral", "hybrid", "perimeters"}) {
    settings.infill.strategy = strategy;
    const Plan plan = plannedPart(bridge(), settings);
    EXPECT_EQ(plan.bridging.bridges, 0U) << strategy;
    EXPECT_TRUE(threadsOf(plan.toolpath.layers[5]).empty()) << strategy;
  }
  settings.infill.strategy = "zigzag";
  EXPECT_EQ(plannedPart(bridge(), settings).bridging.bridges, 1U) << "its lines end at the rim anyway";
  settings.infill.strategy = "spiral";
  settings.walls.count = 1;
  EXPECT_EQ(plannedPart(bridge(), settings).bridging.bridges, 1U) << "the threads end at the wall";
}

TEST(Bridges, AreDepositedWithoutSkinsToo) {
  PlanSettings settings = spanning();
  settings.skins = SkinSettings{};
  const Plan plan = plannedPart(bridge(), settings);
  EXPECT_GE(spansOf(threadsOf(plan.toolpath.layers[5])).size(), 51U);
  for (const ToolpathLayer& layer : plan.toolpath.layers)
    for (const Path& path : layer.paths)
      EXPECT_TRUE(path.role != PathRole::Skin && path.role != PathRole::BottomSkin &&
                  path.role != PathRole::TopSkin);
}

TEST(Bridges, CloseARoundHole) {
  const auto layers = test::layersOf(8, [](int l) {
    std::vector<Polygon> contours{rectangle(-15, -15, 15, 15)};
    if (l < 4) contours.push_back(test::reversed(test::circle(Point2::Zero(), 5.0, 180)));
    return contours;
  });
  const Plan plan = plannedPart(layers, spanning());
  EXPECT_EQ(plan.bridging.bridges, 1U);
  EXPECT_NEAR(plan.bridging.longest_mm, 10.0, 0.02);
  for (const Path& thread : threadsOf(plan.toolpath.layers[4]))
    for (const Point3& end : thread.points) EXPECT_GE(end.head<2>().norm(), 5.0 + 0.15) << "on the rim";
}

TEST(Bridges, OfOneSideAreNone) {
  // A plate of which a third stands on a block.
  const auto layers = test::layersOf(
      10, [](int l) { return std::vector<Polygon>{rectangle(0, 0, l < 5 ? 10.0 : 30.0, 20)}; });
  const Plan plan = plannedPart(layers, spanning());
  EXPECT_EQ(plan.bridging.bridges, 0U);
  EXPECT_EQ(plan.bridging.unheld, 1U);
  EXPECT_NEAR(plan.bridging.unheld_mm2, (20.0 - kTwoWalls) * (20.0 - 2.0 * kTwoWalls), 1.0);
  double hanging = 0.0;
  for (const Path& path : plan.toolpath.layers[5].paths) {
    EXPECT_NE(path.role, PathRole::Bridge);
    if (path.role != PathRole::BottomSkin) continue;
    hanging += depositedVolume(path);
    EXPECT_NEAR(path.feed_mm_s.at(1), 0.35 * 45.0, 1e-9) << "an overhang of full width";
  }
  EXPECT_GT(hanging, 0.99 * (20.0 - kTwoWalls) * (20.0 - 2.0 * kTwoWalls) * 0.2);
}

TEST(Bridges, LongerThanAskedAreReported) {
  PlanSettings settings = spanning();
  settings.bridges.longest_mm = 15.0;
  EXPECT_EQ(plannedPart(bridge(), settings).bridging.too_long, 1U);
  settings.bridges.longest_mm = 25.0;
  EXPECT_EQ(plannedPart(bridge(), settings).bridging.too_long, 0U);
}

TEST(Bridges, OfRoundThreadsHaveTheirSection) {
  PlanSettings settings = spanning();
  settings.bridges.thread = BridgeThread::Round;
  const std::vector<Path> threads = threadsOf(plannedPart(bridge(), settings).toolpath.layers[5]);
  EXPECT_NEAR(static_cast<double>(spansOf(threads).size()), (20.0 - 2.0 * kTwoWalls) / 0.45, 0.51);
  for (const Path& thread : threads)
    EXPECT_NEAR(depositedVolume(thread) / length(thread), 0.04 * M_PI, 1e-9) << "0.1257 mm2";
  settings.bridges.thread = BridgeThread::Bead;
  settings.bridges.flow = 0.8;
  for (const Path& thread : threadsOf(plannedPart(bridge(), settings).toolpath.layers[5]))
    EXPECT_NEAR(depositedVolume(thread) / length(thread), 0.8 * 0.2 * kThreadPitch, 1e-9);
}

TEST(Bridges, GoAsTheyAreSet) {
  PlanSettings settings = spanning();
  settings.bridges.angle_deg = 10.0;
  settings.bridges.least_held = 0.3;
  const auto threads = threadsOf(plannedPart(bridge(), settings).toolpath.layers[5]);
  ASSERT_FALSE(threads.empty());
  for (const Path& thread : threads) {
    const Point3 way = thread.points[1] - thread.points[0];
    EXPECT_NEAR(way.y() / way.x(), std::tan(10.0 * M_PI / 180.0), 1e-6);
  }
}

TEST(Bridges, OnBothSidesOfAPierShareIt) {
  // Two gaps of 6 mm, a pier of 1 mm between them: both anchors end in its middle.
  const Regions below = unite({rectangle(0, 0, 5, 10), rectangle(11, 0, 12, 10), rectangle(18, 0, 23, 10)});
  const Regions inside = unite({rectangle(1, 1, 22, 9)});
  const ThreadLayout layout{0.0, kThreadPitch, 1.0};
  const auto left = bridgeThreads({rectangle(5, 1, 11, 9), {}}, below, inside, layout);
  const auto right = bridgeThreads({rectangle(12, 1, 18, 9), {}}, below, inside, layout);
  ASSERT_EQ(left.size(), 1U);
  ASSERT_EQ(right.size(), 1U);
  // 22 threads of 0.364 mm, all joined: those that are cut end half of that earlier.
  const double cut = 0.5 * 8.0 / 22.0;
  const auto expectEnds = [cut](const FillPath& run, double low, double high) {
    ASSERT_EQ(run.points.size(), 44U);
    for (const Point2& point : run.points) {
      const double inwards = point.x() < 0.5 * (low + high) ? point.x() - low : high - point.x();
      EXPECT_TRUE(std::abs(inwards) < 1e-4 || std::abs(inwards - cut) < 1e-4) << point.x();
    }
  };
  expectEnds(left[0], 4.0, 11.5);
  expectEnds(right[0], 11.5, 19.0);
}

TEST(Bridges, KeepWithinTheWalls) {
  // The ledge that holds them is narrower than the anchor.
  const Regions below = unite({rectangle(0, 0, 20, 10), test::reversed(rectangle(1, 1, 19, 9))});
  const Regions inside = unite({rectangle(0.7, 0.7, 19.3, 9.3)});
  const ThreadLayout layout{0.5 * M_PI, kThreadPitch, 1.0};
  const std::vector<FillPath> threads = bridgeThreads({rectangle(1, 1, 19, 9), {}}, below, inside, layout);
  ASSERT_FALSE(threads.empty());
  for (const FillPath& thread : threads)
    for (const Point2& end : thread.points) {
      EXPECT_GE(end.y(), 0.7 + 0.48 * kThreadPitch);
      EXPECT_LE(end.y(), 9.3 - 0.48 * kThreadPitch);
    }
}

TEST(Bridges, OverInfillCrossItsLines) {
  const auto layers = test::layersOf(20, [](int) { return std::vector<Polygon>{rectangle(0, 0, 30, 30)}; });
  PlanSettings settings = spanning();
  settings.infill.alternation_deg = 0.0;  // always at 45 deg
  settings.skins.angle_deg = 20.0;
  settings.bridges.is_over_infill = true;
  const Toolpath toolpath = plannedPart(layers, settings).toolpath;
  for (const std::size_t l : {15U, 16U, 17U}) {
    double across = 0.0;
    double all = 0.0;
    for (const Path& path : toolpath.layers[l].paths) {
      if (path.role != PathRole::Skin) continue;
      if (l == 16) {
        EXPECT_EQ(path.feed_mm_s.at(1), 20.0);
      }
      for (std::size_t m = 0; m < path.motionCount(); ++m) {
        const Point3 way = path.points[path.motionEnd(m)] - path.points[m];
        all += way.norm();
        if (std::abs(way.x() + way.y()) < 1e-6 * way.norm()) across += way.norm();
      }
    }
    if (l == 16)
      EXPECT_GT(across, 0.9 * all) << "at 135 deg";
    else
      EXPECT_LT(across, 0.1 * all + 1e-9) << l;
  }
}

/// Far out along a belt, where inclined layers are planned near the origin.
std::vector<Layer> movedAlong(std::vector<Layer> layers, double by_mm) {
  for (Layer& layer : layers)
    for (Polygon& contour : layer.section.contours)
      for (Point2& point : contour) point.y() += by_mm;
  return layers;
}

/// Over a bed that rises by 20 deg along -y against the layers, and has its trace at y = 0 in layer 0.
Plan inclinedPlan(const std::vector<Layer>& layers, double level_mm) {
  const Point3 up(0.0, std::sin(M_PI / 9.0), std::cos(M_PI / 9.0));
  NoProgress nobody;
  PlanSettings settings = spanning();
  settings.anchoring.strategy = Anchoring::None;  // the bed may lie far below
  Plan plan = planPart("part", layers, settings, LayerIncline{{up, level_mm}, {}}, nobody);
  validate(plan.toolpath);
  return plan;
}

TEST(Bridges, SpanGapsInInclinedLayers) {
  for (const double out_mm : {0.0, 5000.0}) {
    const double level_mm = out_mm * std::sin(M_PI / 9.0) - 50.0;
    const Plan plan = inclinedPlan(movedAlong(bridge(), out_mm), level_mm);
    EXPECT_EQ(plan.bridging.bridges, 1U) << out_mm;
    EXPECT_NEAR(plan.bridging.longest_mm, 20.0, 1e-3);
    const std::vector<Path> threads = threadsOf(plan.toolpath.layers[5]);
    const double volume = (20.0 + 2.0 * 1.0) * (20.0 - 2.0 * kTwoWalls) * 0.2;
    EXPECT_NEAR(threadVolume(threads), volume, 0.01 * volume);
    for (const Path& thread : threads) EXPECT_EQ(thread.feed_mm_s.at(1), 20.0);
  }
}

TEST(Bridges, NeedNoneWhereAnInclinedLayerStandsOnTheBed) {
  // Level 20 mm: the bed carries the whole layer. In between its trace carries half of it.
  EXPECT_EQ(inclinedPlan(bridge(), 20.0).bridging.bridges, 0U);
  const double half_mm = 10.0 * std::sin(M_PI / 9.0) + 0.9 * std::cos(M_PI / 9.0);  // y = 10, layer 4
  const Plan plan = inclinedPlan(bridge(), half_mm);
  double deposited_mm = 0.0;
  for (const Path& thread : threadsOf(plan.toolpath.layers[5])) {
    EXPECT_GT(thread.points[0].y(), 10.0 - 1.1) << "the trace lies at y = 10 and below, and holds threads";
    deposited_mm += length(thread);
  }
  EXPECT_GT(deposited_mm, 20.0);
}

TEST(Bridges, OverAGridCrossBothOfItsDirections) {
  const auto layers = test::layersOf(20, [](int) { return std::vector<Polygon>{rectangle(0, 0, 30, 30)}; });
  PlanSettings settings = spanning();
  settings.infill.strategy = "grid";
  settings.infill.angle_deg = 10.0;  // lines at 10 and 100 deg in all layers
  settings.bridges.is_over_infill = true;
  double between = 0.0;
  double all = 0.0;
  const Plan plan = plannedPart(layers, settings);
  for (const Path& path : plan.toolpath.layers[16].paths)
    for (std::size_t m = 0; path.role == PathRole::Skin && m < path.motionCount(); ++m) {
      const Point3 way = path.points[path.motionEnd(m)] - path.points[m];
      const double turned_deg = std::atan2(way.y(), way.x()) * 180.0 / M_PI - 55.0;
      all += way.norm();
      if (std::abs(std::remainder(turned_deg, 90.0)) < 0.01) between += way.norm();
    }
  EXPECT_GT(between, 0.9 * all) << "at 55 or 145 deg";
  EXPECT_GT(all, 100.0);
}

TEST(Bridges, CloseAHollowPartFromWallToWall) {
  const auto layers = test::layersOf(20, [](int) { return std::vector<Polygon>{rectangle(0, 0, 30, 18)}; });
  PlanSettings settings = spanning();
  settings.infill.density = 0.0;
  settings.bridges.is_over_infill = true;
  const Plan plan = plannedPart(layers, settings);
  EXPECT_EQ(plan.bridging.bridges, 1U);
  EXPECT_NEAR(plan.bridging.longest_mm, 18.0 - 2.0 * kTwoWalls, 1e-3) << "the shorter way";
  const double volume = (30.0 - 2.0 * kTwoWalls) * (18.0 - 2.0 * kTwoWalls) * 0.2;
  for (std::size_t l = 0; l < 20; ++l) {
    const double deposited = threadVolume(threadsOf(plan.toolpath.layers[l]));
    if (l == 16)
      EXPECT_NEAR(deposited, volume, 0.03 * volume);
    else
      EXPECT_EQ(deposited, 0.0) << l;
  }
}

TEST(BridgedAreas, ShareOutTheAreaOnce) {
  EXPECT_TRUE(rc::check([](std::uint64_t seed) {
    Random random(seed);
    const Regions inside = unite({rectangle(-15, -15, 15, 15)});
    std::vector<Polygon> pillars;
    for (int i = 0; i < 4; ++i)
      pillars.push_back(test::star(random, {random.uniform(-15, 15), random.uniform(-15, 15)}, 3.0, 9.0, 9));
    const Regions below = unite(pillars);
    BridgeMeasures measures;
    measures.thread_pitch_mm = kThreadPitch;
    const BridgedAreas areas = bridgedAreas(inside, below, measures);
    std::vector<Polygon> covered;
    for (const DepositedBridge& bridge : areas.bridges) {
      for (const Polygon& outline : outlines(bridge.area)) covered.push_back(outline);
      for (const FillPath& thread : bridge.threads)
        for (const Point2& end : thread.points)
          RC_ASSERT(end.cwiseAbs().maxCoeff() < 15.0 - 0.3 * kThreadPitch);
    }
    const double shared = area(unite(covered)) + area(areas.hanging) + area(areas.rest);
    RC_ASSERT(std::abs(shared - 900.0) < 1e-2);
    // Nothing of what is wider than a bead and over nothing is left to the usual skins.
    RC_ASSERT(area(intersection(areas.rest, overNothing(inside, below, measures.narrowest_mm))) < 0.05);
    RC_ASSERT(areas.counts.bridges == areas.bridges.size());
  }));
}

TEST(Bridges, ChangeNothingWhereNothingHangs) {
  const auto layers =
      test::layersOf(10, [](int l) { return std::vector<Polygon>{rectangle(0, 0, 30.0 - 2.0 * l, 30)}; });
  PlanSettings without = spanning();
  without.bridges.is_used = false;
  EXPECT_EQ(toolpathId(plannedPart(layers, spanning()).toolpath),
            toolpathId(plannedPart(layers, without).toolpath));
}

TEST(Bridges, AreTheSameForAnyNumberOfThreads) {
  std::set<std::string> ids;
  for (const int threads : {1, 3}) {
    const ThreadLimit limit(threads);
    ids.insert(toolpathId(plannedPart(bridge(), spanning()).toolpath));
  }
  EXPECT_EQ(ids.size(), 1U);
}

}  // namespace
}  // namespace lamina
