// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/supports/stacked_material.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "geometry/polygon/region_lists.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/geometry/polygon/simplify.hpp"
#include "planning/supports/piecewise.hpp"

namespace lamina {
namespace {

constexpr double kBeyondPart = 100.0;  // mm: farther out no support of a part stands
constexpr double kLeastRegion = 1e-6;  // mm2

/// Within the half plane where the coordinate is at least, or at most, a limit.
Polygon cutAt(const Polygon& polygon, Eigen::Index axis, double limit, double sign) {
  Polygon kept;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const double from = sign * (polygon[j][axis] - limit);
    const double to = sign * (polygon[i][axis] - limit);
    if ((from < 0.0) != (to < 0.0))
      kept.push_back(polygon[j] + from / (from - to) * (polygon[i] - polygon[j]));
    if (to >= 0.0) kept.push_back(polygon[i]);
  }
  return kept;
}

Polygon cutToBox(const Polygon& polygon, const Box2& box) {
  const Box2 own = boundingBox({polygon});
  if ((own.low.array() > box.high.array()).any() || (own.high.array() < box.low.array()).any()) return {};
  Polygon cut = polygon;
  for (const Eigen::Index axis : {0, 1}) {
    if (own.low[axis] < box.low[axis]) cut = cutAt(cut, axis, box.low[axis], 1.0);
    if (own.high[axis] > box.high[axis] && !cut.empty()) cut = cutAt(cut, axis, box.high[axis], -1.0);
  }
  return cut;
}

}  // namespace

Regions within(const Regions& regions, const Box2& box, double reach_mm) {
  Regions near;
  if (box.isEmpty()) return near;
  const Box2 around{box.low - Point2::Constant(reach_mm), box.high + Point2::Constant(reach_mm)};
  for (const Region& region : regions) {
    Region cut;
    cut.outer = cutToBox(region.outer, around);
    if (cut.outer.size() < 3) continue;
    for (const Polygon& hole : region.holes) {
      Polygon border = cutToBox(hole, around);
      if (border.size() >= 3) cut.holes.push_back(std::move(border));
    }
    near.push_back(std::move(cut));
  }
  return near;
}

Box2 boxOf(const Regions& regions) {
  Box2 box;
  for (const Region& region : regions)
    for (const Point2& point : region.outer) box.include(point);
  return box;
}

Regions withoutNarrowPieces(Regions regions, double narrowest_mm) {
  const auto isNarrow = [narrowest_mm](const Region& region) {
    return !surelyHasRoom(region, 0.5 * narrowest_mm) && offset({region}, -0.5 * narrowest_mm).empty();
  };
  regions.erase(std::remove_if(regions.begin(), regions.end(), isNarrow), regions.end());
  return regions;
}

Point2 StackedMaterial::fall() const {
  if (!bed) return Point2::Zero();
  return -bed->up.head<2>() / bed->up.z();
}

Regions StackedMaterial::bedIn(std::size_t layer) const {
  if (!bed || box.isEmpty()) return {};
  const Point2 low = box.low - Point2::Constant(kBeyondPart);
  const Point2 high = box.high + Point2::Constant(kBeyondPart);
  const Polygon around = {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
  const auto height = [&](const Point2& point) {
    return bed->heightOf({point.x(), point.y(), bounds[layer].cut()});
  };
  Polygon inside;
  for (std::size_t i = 0, j = around.size() - 1; i < around.size(); j = i++) {
    const double from = height(around[j]);
    const double to = height(around[i]);
    if ((from <= 0.0) != (to <= 0.0))
      inside.push_back(around[j] + from / (from - to) * (around[i] - around[j]));
    if (to <= 0.0) inside.push_back(around[i]);
  }
  if (inside.size() < 3) return {};
  return {Region{std::move(inside), {}}};
}

StackedMaterial stackedMaterial(const std::vector<Layer>& layers, double tolerance_mm,
                                const std::optional<BedPlane>& bed, Progress& progress) {
  StackedMaterial stack;
  stack.bed = bed;
  std::vector<Regions> united_layers(layers.size());
  const auto unite_layer = [&](std::size_t i) {
    united_layers[i] = unite(simplify(layers[i].section.contours, tolerance_mm));
  };
  parallelFor(layers.size(), unite_layer, progress, "supports");
  for (std::size_t i = 0; i < layers.size(); ++i) {
    stack.bounds.push_back(layers[i].bounds);
    for (const Region& region : united_layers[i])
      for (const Point2& point : region.outer) stack.box.include(point);
    const bool is_same = i > 0 && areEqual(*stack.material.back(), united_layers[i]);
    stack.material.push_back(is_same ? stack.material.back()
                                     : std::make_shared<const Regions>(std::move(united_layers[i])));
  }
  return stack;
}

Regions united(const Regions& a, const Regions& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  std::vector<Polygon> borders = outlines(a);
  std::vector<Polygon> others = outlines(b);
  std::move(others.begin(), others.end(), std::back_inserter(borders));
  return unite(borders);
}

Regions simplified(const Regions& regions, double tolerance_mm) {
  Regions simple;
  for (const Region& region : regions) {
    Region kept;
    kept.outer = simplify(region.outer, tolerance_mm);
    if (kept.outer.size() < 3) continue;
    for (const Polygon& hole : region.holes) {
      Polygon border = simplify(hole, tolerance_mm);
      if (border.size() >= 3) kept.holes.push_back(std::move(border));
    }
    if (area({kept}) > kLeastRegion) simple.push_back(std::move(kept));
  }
  return simple;
}

Regions withoutNarrow(const Regions& regions, double narrowest_mm) {
  if (regions.empty() || narrowest_mm <= 0.0) return regions;
  return offset(offset(regions, -0.5 * narrowest_mm), 0.5 * narrowest_mm);
}

}  // namespace lamina
