// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// What each strategy of beads promises besides `EveryStrategy`, whose paths are centre lines: the beads leave
// little open, and little of them lies on each other or outside of the region.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/voids/beads/void_map.hpp"
#include "support/fill_requests.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

using test::circle;
using test::rectangle;
using test::requestOf;
using test::reversed;

constexpr double kPitch = 0.4;
constexpr double kStrategyVoidsHeight = 0.2;

Path toPath(const FillPath& run) {
  Path path;
  path.role = run.role;
  path.is_closed = run.is_closed;
  for (const Point2& point : run.points) path.points.emplace_back(point.x(), point.y(), kStrategyVoidsHeight);
  path.bead = beadOfArea(kPitch * kStrategyVoidsHeight, kStrategyVoidsHeight);
  path.feed_mm_s = 30.0;
  if (run.width_mm.empty()) return path;
  std::vector<Bead> beads;
  for (const double width : run.width_mm)
    beads.push_back(beadOfArea(width * kStrategyVoidsHeight, kStrategyVoidsHeight));
  path.bead = AlongPath<Bead>(std::move(beads));
  return path;
}

struct NamedRegion {
  std::string name;
  Regions regions;
};

std::vector<NamedRegion> regions() {
  return {{"square", {{rectangle(0, 0, 20, 20), {}}}},
          {"ring", {{circle({0, 0}, 12, 120), {reversed(circle({0, 0}, 5, 80))}}}},
          {"islands",
           {{rectangle(-10, -10, 10, 10),
             {reversed(circle({-4, 0}, 2.5, 60)), reversed(rectangle(2, -2, 5, 3))}}}},
          {"L", {{{{0, 0}, {20, 0}, {20, 8}, {8, 8}, {8, 20}, {0, 20}}, {}}}}};
}

/// What may be open and overfilled.
struct Bounds {
  double uncovered = 0.005;  ///< as a share of the area
  double rim = 0.0;          ///< uncovered besides, along the border, in pitches
  double overfill = 0.03;    ///< as a share of the area
};

Bounds boundsOf(const std::string& strategy) {
  Bounds bounds;
  // Contours follow the border and each other; what they fill twice is at links and at the ends of rests.
  if (strategy == "contour" || strategy == "spiral" || strategy == "perimeters") bounds.overfill = 0.01;
  // The curve is cut at the border, where its last corners and what lies between its ends stay open.
  if (strategy == "hilbert") bounds.rim = 0.4;
  // Whole cells of the lattice are visited: at an oblique border more than half a cell stays open. The
  // planner lays walls round both.
  if (strategy == "hilbert_quadtree") bounds.rim = 0.8;
  return bounds;
}

double borderLength(const Regions& regions) {
  double sum = 0.0;
  for (const Polygon& outline : outlines(regions)) sum += perimeter(outline);
  return sum;
}

class BeadStrategy : public testing::TestWithParam<std::string> {
 protected:
  LayerVoids voidsOf(const Regions& regions, const InfillRequest& request) const {
    ToolpathLayer layer;
    layer.z_mm = layer.height_mm = kStrategyVoidsHeight;
    for (const FillPath& run : infillStrategy(GetParam()).fill(regions, request))
      layer.paths.push_back(toPath(run));
    return findVoids(regions, layer, {});
  }
};

Regions scaled(Regions regions, double scale) {
  for (Region& region : regions) {
    for (Point2& point : region.outer) point *= scale;
    for (Polygon& hole : region.holes)
      for (Point2& point : hole) point *= scale;
  }
  return unite(outlines(regions));
}

TEST_P(BeadStrategy, LeavesLittleOpenAndLaysLittleTwiceOrOutside) {
  const Bounds bounds = boundsOf(GetParam());
  Random random(3);
  for (const NamedRegion& region : regions())
    for (std::size_t layer = 0; layer < 6; ++layer) {
      const double scale = random.uniform(0.7, 1.4);
      InfillRequest request = requestOf(kPitch, layer < 2 ? layer * M_PI / 2 : random.uniform(-M_PI, M_PI));
      request.layer = layer;
      SCOPED_TRACE(testing::Message()
                   << region.name << " x " << scale << ", " << request.angle_rad << " rad");
      const Regions part = scaled(region.regions, scale);
      const LayerVoids voids = voidsOf(part, request);
      const double rim_mm2 = bounds.rim * kPitch * borderLength(part);
      EXPECT_LE(voids.uncovered_mm2, bounds.uncovered * voids.area_mm2 + rim_mm2);
      EXPECT_LE(voids.overfill_mm2, bounds.overfill * voids.area_mm2);
    }
}

std::vector<std::string> solidBeadStrategies() {
  std::vector<std::string> names;
  for (const std::string& name : infillStrategyNames()) {
    const InfillStrategy strategy = infillStrategy(name);
    if (strategy.deposit == Deposit::Bead && strategy.link != LayerLink::Rising) names.push_back(name);
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(Voids, BeadStrategy, testing::ValuesIn(solidBeadStrategies()),
                         [](const testing::TestParamInfo<std::string>& strategy) { return strategy.param; });

}  // namespace
}  // namespace lamina
