// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/skirt.hpp"

#include <algorithm>
#include <utility>

#include "lamina/geometry/polygon/convex_hull.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {

std::vector<Polygon> makeSkirt(const Regions& first_layer, const PlanSettings& settings) {
  std::vector<Point2> points;
  for (const Region& region : first_layer)
    points.insert(points.end(), region.outer.begin(), region.outer.end());
  const Polygon hull = convexHull(std::move(points));
  std::vector<Polygon> loops;
  if (hull.empty() || settings.skirt.count == 0) return loops;
  double length_mm = 0.0;
  for (int i = 0; i < settings.skirt.count || length_mm < settings.skirt.least_length_mm; ++i) {
    const double distance = settings.skirt.distance_mm + (i + 0.5) * settings.bead.width_mm;
    for (Region& region : offset({Region{hull, {}}}, distance, Join::Round)) {
      length_mm += perimeter(region.outer);
      loops.push_back(std::move(region.outer));
    }
  }
  std::reverse(loops.begin(), loops.end());
  return loops;
}

}  // namespace lamina
