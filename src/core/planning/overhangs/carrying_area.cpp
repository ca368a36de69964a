// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/overhangs/carrying_area.hpp"

#include <vector>

#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

constexpr double kBesideLayer = 1.0;  // mm
constexpr double kOnBed = 1e-6;       // mm: rounding of rotations

/// The part of a convex outline at which the height is 0 or less.
Polygon lowerPart(const Polygon& outline, const BedPlane& bed, double foot_mm) {
  const auto height = [&](const Point2& point) {
    return bed.heightOf({point.x(), point.y(), foot_mm}) - kOnBed;
  };
  Polygon part;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const double from = height(outline[j]);
    const double to = height(outline[i]);
    if ((from <= 0.0) != (to <= 0.0))
      part.emplace_back(outline[j] + from / (from - to) * (outline[i] - outline[j]));
    if (to <= 0.0) part.push_back(outline[i]);
  }
  return part;
}

}  // namespace

Regions carryingArea(const Layer& layer, const LayerCover& cover, const std::optional<BedPlane>& bed) {
  if (!bed) return *cover.below;
  const Box2 box = boundingBox(layer.section.contours);
  if (box.isEmpty()) return *cover.below;
  const Point2 low = box.low.array() - kBesideLayer;
  const Point2 high = box.high.array() + kBesideLayer;
  // The section of the layer below ends where the bed passes through its middle.
  const double foot_mm = layer.bounds.bottom_mm - 0.5 * layer.bounds.height();
  const Polygon strip = lowerPart({low, {high.x(), low.y()}, high, {low.x(), high.y()}}, *bed, foot_mm);
  if (strip.size() < 3) return *cover.below;
  std::vector<Polygon> all = outlines(*cover.below);
  all.push_back(strip);
  return unite(all);
}

bool isCarried(const LayerCover& cover, const std::optional<BedPlane>& bed, std::size_t index) {
  return cover.below == cover.material || (index == 0 && !bed);
}

}  // namespace lamina
