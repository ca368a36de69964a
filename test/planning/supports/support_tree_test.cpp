// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Branches that hold up what hangs over.
#include "planning/supports/support_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "planning/supports/branch_loops.hpp"
#include "planning/supports/overhang_areas.hpp"
#include "support/supported_parts.hpp"

namespace lamina {
namespace {

using test::kLayerHeight;
using test::rectangle;
using test::tee;

SupportSettings branching() {
  SupportSettings settings;
  settings.use = true;
  settings.kind = SupportKind::Tree;
  settings.angle_deg = 45.0;
  return settings;
}

SupportTree treeBelow(const std::vector<Layer>& layers, const SupportSettings& settings) {
  NoProgress nobody;
  const StackedMaterial stack = stackedMaterial(layers, 0.005, {}, nobody);
  const std::vector<Regions> overhangs = overhangAreas(stack, settings, nobody);
  return growBranches(stack, branchTips(stack, overhangs, {0.4, 0.8}, settings), settings, nobody);
}

Plan plannedWithBranches(const std::vector<Layer>& layers, const SupportSettings& supports) {
  PlanSettings settings;
  settings.skirt.count = 0;
  settings.supports = supports;
  NoProgress nobody;
  Plan plan = planPart("part", layers, settings, nobody);
  validate(plan.toolpath);
  return plan;
}

TEST(SupportTree, HasATipNearEveryPlaceThatHangsOver) {
  const SupportTree tree = treeBelow(tee(), branching());
  EXPECT_EQ(tree.dropped, 0U);
  std::vector<Polygon> near_tips;
  for (const BranchTip& tip : tree.tips)
    near_tips.push_back(test::circle(tip.at, branching().tip_spacing_mm, 64));
  const Regions wings = unite({rectangle(-20, -20, -5, 20), rectangle(5, -20, 20, 20)});
  EXPECT_NEAR(area(difference(wings, unite(near_tips))), 0.0, 1e-6);
  // Tips are where branches touch, a gap of 0.2 mm below the slab.
  for (const BranchTip& tip : tree.tips) {
    EXPECT_EQ(tip.top.full_layers, 99U);
    EXPECT_TRUE(std::any_of(tree.layers[98].begin(), tree.layers[98].end(), [&](const BranchDisc& disc) {
      return disc.at == tip.at && std::abs(disc.top_mm - 19.8) < 1e-9;
    }));
  }
}

/// How far each branch goes aside from one layer to the next at most; where branches met, to the one that
/// goes on. More than 100 mm if one stands on nothing.
double greatestStep(const SupportTree& tree) {
  double greatest = 0.0;
  for (std::size_t l = 0; l + 1 < tree.layers.size(); ++l)
    for (const BranchDisc& disc : tree.layers[l + 1]) {
      double nearest = 1000.0;
      const BranchDisc* own = nullptr;
      for (const BranchDisc& below : tree.layers[l]) {
        nearest = std::min(nearest, (below.at - disc.at).norm());
        if (below.branch == disc.branch) own = &below;
      }
      greatest = std::max(greatest, own != nullptr ? (own->at - disc.at).norm() : nearest);
    }
  return greatest;
}

TEST(SupportTree, LeansNoMoreThanItsAngle) {
  const SupportTree tree = treeBelow(tee(), branching());
  const double step = kLayerHeight * std::tan(branching().branch_angle_deg * M_PI / 180.0);
  EXPECT_LE(greatestStep(tree), step + 1e-9);
  EXPECT_GT(greatestStep(tree), 0.9 * step);
  for (std::size_t l = 0; l < 99; ++l) EXPECT_FALSE(tree.layers[l].empty()) << l;
  EXPECT_LT(tree.layers[0].size(), tree.layers[98].size() / 8) << "branches have met";
}

/// Outlines of what is deposited of branches in each layer, along the middle of its beads.
std::vector<std::vector<Polygon>> depositedBranches(const Toolpath& toolpath) {
  std::vector<std::vector<Polygon>> deposited(toolpath.layers.size());
  for (std::size_t l = 0; l < deposited.size(); ++l)
    for (const Path& path : toolpath.layers[l].paths) {
      if (path.role != PathRole::Support) continue;
      deposited[l].emplace_back();
      for (const Point3& point : path.points) deposited[l].back().push_back(point.head<2>());
    }
  return deposited;
}

/// Those of the loops that come within a millimetre of a place.
std::vector<Polygon> loopsNear(const std::vector<Polygon>& loops, const Point2& place) {
  std::vector<Polygon> near;
  for (const Polygon& loop : loops) {
    const Box2 box = boundingBox({loop});
    if (((box.low - place).array() < 1.0).all() && ((place - box.high).array() < 1.0).all())
      near.push_back(loop);
  }
  return near;
}

/// How far waypoints of branches lie beyond what is deposited of them in the layer below.
double farthestBeyondBelow(const Toolpath& toolpath) {
  const std::vector<std::vector<Polygon>> deposited = depositedBranches(toolpath);
  double farthest = 0.0;
  for (std::size_t l = 1; l < deposited.size(); ++l)
    for (const Polygon& loop : deposited[l])
      for (const Point2& point : loop) {
        const std::vector<Polygon> below = loopsNear(deposited[l - 1], point);
        if (below.empty()) return 1000.0;
        if (!contains(below, point)) farthest = std::max(farthest, test::distanceToOutline(below, point));
      }
  return farthest;
}

TEST(SupportTree, HasSectionsThatLeanNoMoreThanItsAngle) {
  NoProgress nobody;
  PlanSettings settings;
  settings.supports = branching();
  const std::vector<Regions> areas = branchLoops(treeBelow(tee(), branching()), {}, settings, nobody).areas;
  const double step = kLayerHeight * std::tan(branching().branch_angle_deg * M_PI / 180.0);
  double beyond_less = 0.0;
  for (std::size_t l = 1; l < 99; ++l) {
    const Regions below = unite(outlines(areas[l - 1]));
    EXPECT_NEAR(area(difference(areas[l], offset(below, step + 1e-4))), 0.0, 1e-6) << l;
    beyond_less += area(difference(areas[l], offset(below, 0.8 * step)));
  }
  EXPECT_GT(beyond_less, 1.0);
}

TEST(SupportTree, IsDepositedOnWhatIsDepositedBelow) {
  // By a quarter of a bead at least.
  EXPECT_LE(farthestBeyondBelow(plannedWithBranches(tee(), branching()).toolpath), 0.75 * 0.4);
}

TEST(SupportTree, KeepsItsDistanceFromThePart) {
  const SupportTree tree = treeBelow(tee(), branching());
  for (std::size_t l = 0; l < 99; ++l)
    for (const BranchDisc& disc : tree.layers[l])
      EXPECT_GE(std::abs(disc.at.x()) - 5.0 - disc.radius_mm, 0.6 - 1e-6) << l;
  const Plan plan = plannedWithBranches(tee(), branching());
  for (std::size_t l = 0; l < 100; ++l)
    for (const Path& path : plan.toolpath.layers[l].paths) {
      if (path.role != PathRole::Support) continue;
      const double half_bead = 0.5 * planWidth(path.bead.at(0));
      for (const Point3& point : path.points)
        EXPECT_GE(std::abs(point.x()) - half_bead, 5.0 + 0.6 - 1e-6) << l;
    }
}

TEST(SupportTree, OnTheBedOnlyLeavesASphereUnderAnArchAlone) {
  SupportSettings settings = branching();
  const auto isOnSphere = [](const SupportTree& tree) {
    // The lowest disc of what stands there lies on the upper half of the sphere.
    for (std::size_t l = 41; l < 100; ++l)
      for (const BranchDisc& disc : tree.layers[l]) {
        const auto below =
            std::find_if(tree.layers[l - 1].begin(), tree.layers[l - 1].end(),
                         [&](const auto& each) { return (each.at - disc.at).norm() < kLayerHeight; });
        if (below == tree.layers[l - 1].end()) return true;
      }
    return false;
  };
  EXPECT_TRUE(isOnSphere(treeBelow(test::archOverSphere(), settings)));
  settings.foot = SupportFoot::Bed;
  const SupportTree tree = treeBelow(test::archOverSphere(), settings);
  EXPECT_FALSE(isOnSphere(tree));
  EXPECT_LE(greatestStep(tree), kLayerHeight * std::tan(branching().branch_angle_deg * M_PI / 180.0) + 1e-9)
      << "each stands on the one below, down to the bed";
  for (std::size_t l = 0; l < 100; ++l)
    for (const BranchDisc& disc : tree.layers[l])
      EXPECT_GE(disc.at.norm() - disc.radius_mm, test::sphereRadiusIn(l)) << l;
  // What is deposited lies on what is deposited below it by a quarter of a bead, layer by layer down to the
  // bed.
  EXPECT_LE(farthestBeyondBelow(plannedWithBranches(test::archOverSphere(), settings).toolpath), 0.75 * 0.4);
}

TEST(SupportTree, TakesNoMoreThanTheLattice) {
  SupportSettings lattice = branching();
  lattice.kind = SupportKind::Lattice;
  const SupportTotals columns = plannedWithBranches(tee(), lattice).supports;
  const Plan plan = plannedWithBranches(tee(), branching());
  const SupportTotals branches = plan.supports;
  EXPECT_LE(branches.support_mm3, columns.support_mm3 + columns.interface_mm3);
  double deposited_mm3 = 0.0;
  for (const ToolpathLayer& layer : plan.toolpath.layers)
    for (const Path& path : layer.paths)
      if (path.role == PathRole::Support) deposited_mm3 += depositedVolume(path);
  EXPECT_NEAR(branches.support_mm3, deposited_mm3, 1e-6 * deposited_mm3);
  EXPECT_GT(branches.support_mm3, 100.0);
  EXPECT_NEAR(branches.overhang_mm2, 1200.0, 1e-6);
  EXPECT_NEAR(branches.unsupported_mm2, 0.0, 1e-6);
}

TEST(SupportTree, MeetsTheGapExactly) {
  for (const double gap_mm : {0.0, 0.2, 0.25, 0.35}) {
    SupportSettings settings = branching();
    settings.top_gap_mm = gap_mm;
    double highest = 0.0;
    for (const ToolpathLayer& layer : plannedWithBranches(tee(), settings).toolpath.layers)
      for (const Path& path : layer.paths)
        if (path.role == PathRole::Support) highest = std::max(highest, path.firstPoint().z());
    EXPECT_NEAR(highest, 20.0 - gap_mm, 1e-9);
  }
}

/// A roof of 30 mm on a post, over a plate of that many millimetres.
std::vector<Layer> roofOverPlate(double plate_mm) {
  return test::layersOf(110, [plate_mm](int l) {
    if (l < 10) return std::vector<Polygon>{rectangle(-plate_mm, -plate_mm, plate_mm, plate_mm)};
    if (l < 100) return std::vector<Polygon>{rectangle(-2, -2, 2, 2)};
    return std::vector<Polygon>{rectangle(-15, -15, 15, 15)};
  });
}

TEST(SupportTree, StandsOnThePartOnlyWhereItMay) {
  SupportSettings settings = branching();
  const SupportTree everywhere = treeBelow(roofOverPlate(20), settings);
  EXPECT_EQ(everywhere.dropped, 0U);
  EXPECT_FALSE(everywhere.tips.empty());
  for (std::size_t l = 0; l < 11; ++l) EXPECT_TRUE(everywhere.layers[l].empty()) << "gap above the plate";
  EXPECT_FALSE(everywhere.layers[11].empty());
  settings.foot = SupportFoot::Bed;
  // Round a plate of 12 mm the bed is within reach of all tips; 60 mm are too far for those in the middle.
  const SupportTree beside = treeBelow(roofOverPlate(12), settings);
  EXPECT_EQ(beside.dropped, 0U);
  for (const BranchDisc& disc : beside.layers[5])
    EXPECT_GE(disc.at.cwiseAbs().maxCoeff(), 12.0 + 0.6 + disc.radius_mm - 1e-6);
  EXPECT_TRUE(treeBelow(roofOverPlate(60), settings).tips.empty());
}

TEST(SupportTree, DoesNotDependOnThreads) {
  const std::string many = toolpathId(plannedWithBranches(roofOverPlate(20), branching()).toolpath);
  const ThreadLimit limit(1);
  EXPECT_EQ(toolpathId(plannedWithBranches(roofOverPlate(20), branching()).toolpath), many);
}

}  // namespace
}  // namespace lamina
