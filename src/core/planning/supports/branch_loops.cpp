// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/supports/branch_loops.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

constexpr int kDiscSides = 16;
constexpr double kThickBranch = 3.0;  // mm, radius from which a branch has two loops

Polygon circleRound(const Point2& middle, double radius_mm) {
  Polygon circle;
  for (int i = 0; i < kDiscSides; ++i) {
    const double angle = 2.0 * M_PI * i / kDiscSides;
    circle.push_back(middle + radius_mm * Point2(std::cos(angle), std::sin(angle)));
  }
  return circle;
}

void addLoopsOf(const Region& branch, double pitch_mm, std::vector<FillPath>& runs) {
  const bool may_be_thick = boundingBox({branch.outer}).size().minCoeff() > 2.0 * kThickBranch;
  const int count = !may_be_thick || offset({branch}, -kThickBranch).empty() ? 1 : 2;
  for (int i = 0; i < count; ++i)
    for (Polygon& loop : outlines(offset({branch}, -(i + 0.5) * pitch_mm)))
      runs.push_back({std::move(loop), true, PathRole::Support, Deposit::Bead, {}});
}

AidRuns loopsIn(const Regions& area, double bottom_mm, double top_mm, const PlanSettings& settings) {
  AidRuns aids;
  aids.bead = {settings.bead.width_mm, top_mm - bottom_mm};
  aids.top_mm = top_mm;
  aids.tool = static_cast<std::uint32_t>(std::max(0, settings.supports.tool));
  aids.area = std::make_shared<const Regions>(area);
  std::vector<FillPath> runs;
  for (const Region& branch : area) addLoopsOf(branch, planWidth(aids.bead), runs);
  aids.runs = std::make_shared<const std::vector<FillPath>>(std::move(runs));
  return aids;
}

}  // namespace

BranchLoops branchLoops(const SupportTree& tree, const Regions& taken, const PlanSettings& settings,
                        Progress& progress) {
  BranchLoops loops;
  loops.layers.resize(tree.layers.size());
  loops.areas.resize(tree.layers.size());
  const auto plan_layer = [&](std::size_t i) {
    std::map<std::pair<double, double>, std::vector<Polygon>> circles;  // by top and bottom
    for (const BranchDisc& disc : tree.layers[i])
      circles[{disc.top_mm, disc.bottom_mm}].push_back(circleRound(disc.at, disc.radius_mm));
    for (const auto& [heights, of_height] : circles) {
      Regions area = unite(of_height);
      if (i == 0 && !taken.empty()) area = difference(area, taken);
      AidRuns aids = loopsIn(area, heights.second, heights.first, settings);
      loops.areas[i].insert(loops.areas[i].end(), area.begin(), area.end());
      if (!aids.runs->empty()) loops.layers[i].push_back(std::move(aids));
    }
  };
  parallelFor(tree.layers.size(), plan_layer, progress, "supports");
  return loops;
}

SupportTotals branchTotals(const std::vector<Regions>& overhangs, const SupportTree& tree,
                           const BranchLoops& loops, const SupportSettings& settings) {
  SupportTotals totals;
  totals.dropped_branches = tree.dropped;
  for (const Regions& regions : loops.areas) totals.area_mm2 = std::max(totals.area_mm2, area(regions));
  const double spacing = settings.tip_spacing_mm;
  for (std::size_t j = 0; j < overhangs.size(); ++j) {
    if (overhangs[j].empty()) continue;
    totals.overhang_mm2 += area(overhangs[j]);
    Box2 box = boxOf(overhangs[j]);
    box.low -= Point2::Constant(spacing);
    box.high += Point2::Constant(spacing);
    std::vector<Polygon> near;
    for (const BranchTip& tip : tree.tips)
      if ((tip.at.array() > box.low.array()).all() && (tip.at.array() < box.high.array()).all())
        near.push_back(circleRound(tip.at, spacing));
    totals.unsupported_mm2 += area(difference(overhangs[j], unite(near)));
  }
  return totals;
}

}  // namespace lamina
