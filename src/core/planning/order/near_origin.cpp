// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/near_origin.hpp"

#include <cmath>

namespace lamina {
namespace {

constexpr double kNear = 5e3;   // mm: half of what areas may reach
constexpr double kMetre = 1e3;  // mm

double wholeMetres(double middle_mm) {
  return std::abs(middle_mm) < kNear ? 0.0 : std::round(middle_mm / kMetre) * kMetre;
}

Point2 wholeMetres(const Box2& box) {
  if (box.isEmpty()) return Point2::Zero();
  return {wholeMetres(box.centre().x()), wholeMetres(box.centre().y())};
}

}  // namespace

Point2 distanceFromOrigin(const Layer& layer) { return wholeMetres(boundingBox(layer.section.contours)); }

Point2 distanceFromOrigin(const Regions& regions) {
  Box2 box;
  for (const Region& region : regions)
    for (const Point2& point : region.outer) box.include(point);
  return wholeMetres(box);
}

std::vector<StackStretch> stretchesAlongBelt(const std::vector<Layer>& layers) {
  std::vector<StackStretch> stretches = {{0, layers.size(), Point2::Zero()}};
  bool is_any = false;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (boundingBox(layers[i].section.contours).isEmpty()) continue;
    const Point2 away = distanceFromOrigin(layers[i]);
    const bool is_first = !is_any;
    is_any = true;
    if (is_first) stretches.back().away = away;
    if (away == stretches.back().away) continue;
    stretches.back().end = i;
    stretches.push_back({i, layers.size(), away});
  }
  return stretches;
}

Layer moved(Layer layer, const Point2& by) {
  for (Polygon& contour : layer.section.contours)
    for (Point2& point : contour) point += by;
  return layer;
}

Regions moved(Regions regions, const Point2& by) {
  if (by.isZero()) return regions;
  for (Region& region : regions) {
    for (Point2& point : region.outer) point += by;
    for (Polygon& hole : region.holes)
      for (Point2& point : hole) point += by;
  }
  return regions;
}

}  // namespace lamina
