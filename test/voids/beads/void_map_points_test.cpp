// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>

#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/voids/beads/void_map.hpp"
#include "support/shapes.hpp"

namespace lamina {
namespace {

constexpr double kVoidMapPointsHeight = 0.2;
/// Between the points at which layers are looked at [mm].
constexpr double kStep = 0.04;
/// In pitches: parts of a run nearer along it are one pass, by definition.
constexpr double kOnePass = 1.5;

/// The areas of a layer, found point by point from the distances to all its motions.
struct PointCount {
  double uncovered_mm2 = 0.0;
  double overfill_mm2 = 0.0;
};

/// How many passes of a run fill that point; -1 if none does, but a bead reaches it. Plain numbers, since it
/// is asked millions of times and tests are hardly optimised.
int passesAt(const Path& run, const Point2& at, double one_pass_mm) {
  std::vector<double> arcs;
  bool is_reached = false;
  double arc = 0.0;
  for (std::size_t m = 0; m < run.motionCount(); ++m) {
    const Point3& from = run.points[m];
    const Point3& to = run.points[run.motionEnd(m)];
    const double along[] = {to[0] - from[0], to[1] - from[1]};
    const double offset[] = {at[0] - from[0], at[1] - from[1]};
    const double length = std::sqrt(along[0] * along[0] + along[1] * along[1]);
    const double t = std::clamp((offset[0] * along[0] + offset[1] * along[1]) / (length * length), 0.0, 1.0);
    const double across[] = {offset[0] - t * along[0], offset[1] - t * along[1]};
    const double distance = std::sqrt(across[0] * across[0] + across[1] * across[1]);
    const Bead& bead = run.bead.at(run.motionEnd(m));
    is_reached = is_reached || distance <= 0.5 * bead.width_mm;
    if (distance <= 0.5 * planWidth(bead)) arcs.push_back(arc + t * length);
    arc += length;
  }
  if (arcs.empty()) return is_reached ? -1 : 0;
  std::sort(arcs.begin(), arcs.end());
  int passes = 1;
  for (std::size_t i = 1; i < arcs.size(); ++i) passes += arcs[i] - arcs[i - 1] > one_pass_mm ? 1 : 0;
  const bool closes = run.is_closed && arcs.front() + arc - arcs.back() <= one_pass_mm;
  return closes && passes > 1 ? passes - 1 : passes;
}

PointCount countPoints(const Regions& contour, const ToolpathLayer& layer, double pitch_mm) {
  const std::vector<Polygon> borders = outlines(contour);
  PointCount count;
  for (double y = -2.0 + 0.5 * kStep; y < 12.0; y += kStep)
    for (double x = -2.0 + 0.5 * kStep; x < 12.0; x += kStep) {
      bool is_reached = false;
      int passes = 0;
      for (const Path& run : layer.paths) {
        const int of_run = passesAt(run, {x, y}, kOnePass * pitch_mm);
        is_reached = is_reached || of_run != 0;
        passes += std::max(0, of_run);
      }
      const bool is_inside = contains(borders, {x, y});
      count.uncovered_mm2 += is_inside && !is_reached ? kStep * kStep : 0.0;
      count.overfill_mm2 += std::max(0, passes - (is_inside ? 1 : 0)) * kStep * kStep;
    }
  return count;
}

Path runThrough(const Polyline& points, const std::vector<double>& widths, bool is_closed) {
  Path run;
  run.role = PathRole::Infill;
  run.is_closed = is_closed;
  std::vector<Bead> beads;
  for (const Point2& point : points) run.points.emplace_back(point.x(), point.y(), kVoidMapPointsHeight);
  for (const double width : widths)
    beads.push_back(beadOfArea(width * kVoidMapPointsHeight, kVoidMapPointsHeight));
  run.bead = AlongPath<Bead>(std::move(beads));
  run.feed_mm_s = 10.0;
  return run;
}

Path randomRun(Random& random) {
  Polyline points = {{random.uniform(0, 10), random.uniform(0, 10)}};
  std::vector<double> widths;
  const int corners = 3 + static_cast<int>(random.below(8));
  for (int i = 1; i < corners; ++i) points.emplace_back(random.uniform(0, 10), random.uniform(0, 10));
  for (int i = 0; i < corners; ++i) widths.push_back(random.uniform(0.3, 0.9));
  return runThrough(points, widths, random.below(2) == 0);
}

TEST(VoidMap, AgreesWithACountOfPoints) {
  EXPECT_TRUE(rc::check("runs that cross each other and themselves", [] {
    Random random(*rc::gen::arbitrary<std::uint64_t>());
    const Regions contour = unite(
        {test::star(random, {5, 5}, 2.5, 5.0, 12), test::reversed(test::star(random, {5, 5}, 0.5, 2.0, 7))});
    ToolpathLayer layer;
    layer.z_mm = kVoidMapPointsHeight;
    layer.height_mm = kVoidMapPointsHeight;
    const int runs = 1 + static_cast<int>(random.below(3));
    for (int i = 0; i < runs; ++i) layer.paths.push_back(randomRun(random));
    const LayerVoids voids = findVoids(contour, layer, {});
    const PointCount count = countPoints(contour, layer, voids.pitch_mm);
    RC_ASSERT(std::abs(voids.uncovered_mm2 - count.uncovered_mm2) <
              0.1 + 0.01 * (voids.area_mm2 - voids.uncovered_mm2));
    RC_ASSERT(std::abs(voids.overfill_mm2 - count.overfill_mm2) < 0.2 + 0.02 * count.overfill_mm2);
  }));
}

TEST(VoidMap, CountsARunThatCrossesItselfOnceMore) {
  // A loop back across: two beads 0.5 mm wide that cross at a right angle.
  ToolpathLayer layer;
  layer.z_mm = kVoidMapPointsHeight;
  layer.height_mm = kVoidMapPointsHeight;
  layer.paths = {runThrough({{1, 5}, {9, 5}, {9, 9}, {5, 9}, {5, 1}}, std::vector<double>(5, 0.5), false)};
  const LayerVoids voids = findVoids({{test::rectangle(0, 0, 10, 10), {}}}, layer, {});
  EXPECT_NEAR(voids.overfill_mm2, 0.25, 0.01);
}

}  // namespace
}  // namespace lamina
