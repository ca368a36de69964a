// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/beads/overlap_meter.hpp"

#include <algorithm>
#include <cmath>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/geometry/spatial/point_grid.hpp"
#include "lamina/voids/drops/drop_overlap.hpp"

namespace lamina {
namespace {

void include(OverlapReading& reading, double relative_distance) {
  reading.greatest_linear =
      std::max(reading.greatest_linear, overlapAt(relative_distance, OverlapDefinition::Linear));
  reading.greatest_area =
      std::max(reading.greatest_area, overlapAt(relative_distance, OverlapDefinition::Area));
}

}  // namespace

double OverlapReading::perNewDrop() const { return added == 0 ? 0.0 : sum_area / static_cast<double>(added); }

double OverlapReading::perDrop() const {
  return prior + added == 0 ? 0.0 : sum_area / static_cast<double>(prior + added);
}

OverlapReading operator+(const OverlapReading& a, const OverlapReading& b) {
  OverlapReading sum;
  sum.greatest_linear = std::max(a.greatest_linear, b.greatest_linear);
  sum.greatest_area = std::max(a.greatest_area, b.greatest_area);
  sum.sum_area = a.sum_area + b.sum_area;
  sum.prior = a.prior + b.prior;
  sum.added = a.added + b.added;
  return sum;
}

OverlapReading measureOverlap(const std::vector<Point2>& prior, const std::vector<Point2>& added,
                              double diameter_mm) {
  PointGrid drops(boundingBox({prior}), diameter_mm);
  for (const Point2& drop : prior) drops.insert(drop);
  OverlapReading reading;
  reading.prior = prior.size();
  reading.added = added.size();
  for (const Point2& drop : added) {
    drops.visitNear(drop, diameter_mm, [&](std::uint32_t i, double squared) {
      const double distance = std::sqrt(squared) / diameter_mm;
      include(reading, distance);
      if (i < prior.size()) reading.sum_area += overlapAt(distance, OverlapDefinition::Area);
    });
    drops.insert(drop);
  }
  return reading;
}

}  // namespace lamina
