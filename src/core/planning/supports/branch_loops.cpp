// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/supports/branch_loops.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <memory>
#include <utility>

#include "geometry/spatial/edge_bands.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/geometry/spatial/point_grid.hpp"
#include "planning/tools/tool_beads.hpp"

namespace lamina {
namespace {

constexpr int kDiscSides = 16;
constexpr double kLineDistance = 0.1;  // mm: on which areas without a tip are measured
constexpr double kThickBranch = 3.0;   // mm, radius from which a branch has two loops

using UnitCircle = std::array<Point2, kDiscSides>;

UnitCircle unitCircle() {
  UnitCircle circle;
  for (int i = 0; i < kDiscSides; ++i) {
    const double angle = 2.0 * M_PI * i / kDiscSides;
    circle[static_cast<std::size_t>(i)] = {std::cos(angle), std::sin(angle)};
  }
  return circle;
}

Polygon sectionOf(const BranchDisc& disc, const UnitCircle& circle) {
  Polygon section;
  section.reserve(circle.size());
  for (const Point2& point : circle) section.push_back(disc.at + disc.radius_mm * point);
  return section;
}

void addLoopsOf(const Region& branch, double pitch_mm, std::vector<FillPath>& runs) {
  const bool may_be_thick = boundingBox({branch.outer}).size().minCoeff() > 2.0 * kThickBranch;
  const int count = !may_be_thick || offset({branch}, -kThickBranch).empty() ? 1 : 2;
  for (int i = 0; i < count; ++i)
    for (Polygon& loop : outlines(offset({branch}, -(i + 0.5) * pitch_mm)))
      runs.push_back({std::move(loop), true, PathRole::Support, Deposit::Bead, {}});
}

/// Where a level line crosses a border.
struct LineCrossing {
  std::int64_t line = 0;
  double x = 0.0;
};

double heightOf(std::int64_t line) { return (static_cast<double>(line) + 0.5) * kLineDistance; }

/// Line by line, from left to right.
std::vector<LineCrossing> crossingsOf(const Region& region) {
  std::vector<LineCrossing> crossings;
  forEachEdge(region, [&](const BorderEdge& edge) {
    const auto& [from, to] = edge;
    const auto [low, high] = std::minmax(from.y(), to.y());
    const auto last = static_cast<std::int64_t>(std::floor(high / kLineDistance));
    for (auto line = static_cast<std::int64_t>(std::floor(low / kLineDistance)) - 1; line <= last; ++line) {
      const double y = heightOf(line);
      if ((from.y() > y) == (to.y() > y)) continue;
      crossings.push_back({line, from.x() + (y - from.y()) / (to.y() - from.y()) * (to.x() - from.x())});
    }
  });
  std::sort(crossings.begin(), crossings.end(), [](const LineCrossing& a, const LineCrossing& b) {
    return a.line != b.line ? a.line < b.line : a.x < b.x;
  });
  return crossings;
}

/// Which disc is the first of each one's group: of those that overlap, one by one.
std::vector<std::size_t> groupsOf(const std::vector<BranchDisc>& discs) {
  std::vector<std::size_t> first(discs.size());
  std::vector<std::pair<double, std::size_t>> by_x;
  by_x.reserve(discs.size());
  for (std::size_t i = 0; i < discs.size(); ++i) {
    first[i] = i;
    by_x.emplace_back(discs[i].at.x() - discs[i].radius_mm, i);
  }
  std::sort(by_x.begin(), by_x.end());
  const auto root = [&first](std::size_t i) {
    while (first[i] != i) i = first[i] = first[first[i]];
    return i;
  };
  for (std::size_t a = 0; a < by_x.size(); ++a) {
    const BranchDisc& disc = discs[by_x[a].second];
    const double right = disc.at.x() + disc.radius_mm;
    for (std::size_t b = a + 1; b < by_x.size() && by_x[b].first < right; ++b) {
      const BranchDisc& other = discs[by_x[b].second];
      const double reach = disc.radius_mm + other.radius_mm;
      if ((other.at - disc.at).squaredNorm() >= reach * reach) continue;
      const auto [least, greatest] = std::minmax({root(by_x[a].second), root(by_x[b].second)});
      first[greatest] = least;
    }
  }
  for (std::size_t i = 0; i < first.size(); ++i) first[i] = root(i);
  return first;
}

/// What overlaps, group by group: a sweep over all of them would look at what lies side by side again and
/// again.
std::vector<std::vector<BranchDisc>> overlapping(const std::vector<BranchDisc>& discs) {
  const std::vector<std::size_t> first = groupsOf(discs);
  std::vector<std::vector<BranchDisc>> groups(discs.size());
  for (std::size_t i = 0; i < discs.size(); ++i) groups[first[i]].push_back(discs[i]);
  groups.erase(std::remove_if(groups.begin(), groups.end(), [](const auto& group) { return group.empty(); }),
               groups.end());
  return groups;
}

/// The loops of a branch that meets no other: its section, shrunk.
void addLoopsOf(const BranchDisc& disc, const UnitCircle& circle, double pitch_mm,
                std::vector<FillPath>& runs) {
  const double to_side = std::cos(M_PI / kDiscSides);
  const int count = disc.radius_mm * to_side > kThickBranch ? 2 : 1;
  for (int i = 0; i < count; ++i) {
    const double radius_mm = disc.radius_mm - (i + 0.5) * pitch_mm / to_side;
    if (radius_mm <= 0.0) return;
    runs.push_back(
        {sectionOf({disc.at, radius_mm, 0.0, 0.0, 0}, circle), true, PathRole::Support, Deposit::Bead, {}});
  }
}

/// Finds how much of level lines lies near tips.
class NearTips {
 public:
  NearTips(const std::vector<BranchTip>& tips, double radius_mm)
      : radius_(radius_mm), tips_(boxOf(tips), radius_mm) {
    for (const BranchTip& tip : tips) tips_.insert(tip.at);
  }

  /// Of a level line from a place to another, how much is no nearer to a tip than the radius.
  double lengthBeyond(double y, double from_x, double to_x) {
    reached_.clear();
    const Box2 near{{from_x - radius_, y - radius_}, {to_x + radius_, y + radius_}};
    tips_.visitIn(near, [&](std::uint32_t tip) {
      const Point2& place = tips_.points()[tip];
      const double squared = radius_ * radius_ - (place.y() - y) * (place.y() - y);
      if (squared <= 0.0 || place.x() >= near.high.x()) return;
      const double half = std::sqrt(squared);
      reached_.emplace_back(place.x() - half, place.x() + half);
    });
    std::sort(reached_.begin(), reached_.end());
    double beyond = 0.0;
    double at = from_x;
    for (const auto& [low, high] : reached_) {
      if (low > at) beyond += std::min(low, to_x) - at;
      at = std::max(at, high);
      if (at >= to_x) return beyond;
    }
    return beyond + to_x - at;
  }

 private:
  static Box2 boxOf(const std::vector<BranchTip>& tips) {
    Box2 box;
    for (const BranchTip& tip : tips) box.include(tip.at);
    return box;
  }

  double radius_;
  PointGrid tips_;
  std::vector<std::pair<double, double>> reached_;  ///< of one line
};

/// On level lines through the regions.
double areaBeyond(const Regions& regions, NearTips& tips) {
  double sum = 0.0;
  for (const Region& region : regions) {
    const std::vector<LineCrossing> crossings = crossingsOf(region);
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
      sum +=
          kLineDistance * tips.lengthBeyond(heightOf(crossings[i].line), crossings[i].x, crossings[i + 1].x);
  }
  return sum;
}

/// The loops of branches that end at one height of a layer.
class LayerLoops {
 public:
  /// @param heights  of top and bottom
  LayerLoops(const std::pair<double, double>& heights, const PlanSettings& settings) {
    aids_.bead = beadOf(PathRole::Support, settings, heights.first - heights.second).bead;
    aids_.top_mm = heights.first;
    aids_.tool = static_cast<std::uint32_t>(std::max(0, settings.supports.tool));
  }

  void add(const std::vector<BranchDisc>& group, const UnitCircle& circle, const Regions& taken) {
    if (group.size() == 1 && taken.empty()) {
      area_.push_back({sectionOf(group.front(), circle), {}});
      addLoopsOf(group.front(), circle, planWidth(aids_.bead), runs_);
      return;
    }
    std::vector<Polygon> sections;
    sections.reserve(group.size());
    for (const BranchDisc& disc : group) sections.push_back(sectionOf(disc, circle));
    const Regions joined = group.size() == 1 ? Regions{{sections.front(), {}}} : unite(sections);
    for (const Region& branch : taken.empty() ? joined : difference(joined, taken)) {
      addLoopsOf(branch, planWidth(aids_.bead), runs_);
      area_.push_back(branch);
    }
  }

  AidRuns runs() && {
    aids_.area = std::make_shared<const Regions>(std::move(area_));
    aids_.runs = std::make_shared<const std::vector<FillPath>>(std::move(runs_));
    return std::move(aids_);
  }

 private:
  AidRuns aids_;
  Regions area_;
  std::vector<FillPath> runs_;
};

}  // namespace

BranchLoops branchLoops(const SupportTree& tree, const Regions& taken, const PlanSettings& settings,
                        Progress& progress) {
  BranchLoops loops;
  loops.layers.resize(tree.layers.size());
  loops.areas.resize(tree.layers.size());
  const UnitCircle circle = unitCircle();
  const auto plan_layer = [&](std::size_t i) {
    std::map<std::pair<double, double>, std::vector<BranchDisc>> discs;  // by top and bottom
    for (const BranchDisc& disc : tree.layers[i]) discs[{disc.top_mm, disc.bottom_mm}].push_back(disc);
    for (const auto& [heights, of_height] : discs) {
      LayerLoops of_layer(heights, settings);
      for (const std::vector<BranchDisc>& group : overlapping(of_height))
        of_layer.add(group, circle, i == 0 ? taken : Regions{});
      AidRuns aids = std::move(of_layer).runs();
      loops.areas[i].insert(loops.areas[i].end(), aids.area->begin(), aids.area->end());
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
  NearTips tips(tree.tips, settings.tip_spacing_mm);
  for (const Regions& overhang : overhangs) {
    totals.overhang_mm2 += area(overhang);
    totals.unsupported_mm2 += areaBeyond(overhang, tips);
  }
  return totals;
}

}  // namespace lamina
