// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/nesting.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace lamina {
namespace {

constexpr std::size_t kMostOutlines = 64;
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

struct Outline {
  const Polygon* points;
  Box2 box;
  double area;
};

bool isNestedIn(const Outline& outline, const Point2& point) {
  return (point - outline.box.low).minCoeff() >= 0.0 && (outline.box.high - point).minCoeff() >= 0.0 &&
         encloses(*outline.points, point);
}

/// What lies round an outline: how often it is wound round, and the smallest that does.
struct Surroundings {
  int winding = 0;
  std::size_t parent = kNone;
};

Surroundings surroundingsOf(std::size_t of, const std::vector<Outline>& all) {
  Surroundings result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i == of || !isNestedIn(all[i], all[of].points->front())) continue;
    result.winding += all[i].area > 0.0 ? 1 : -1;
    if (result.parent == kNone || std::abs(all[i].area) < std::abs(all[result.parent].area))
      result.parent = i;
  }
  return result;
}

}  // namespace

std::optional<Regions> nest(std::vector<Polygon> outlines) {
  if (outlines.size() > kMostOutlines) return std::nullopt;
  std::vector<Outline> all;
  all.reserve(outlines.size());
  for (const Polygon& outline : outlines) {
    all.push_back({&outline, {}, signedArea(outline)});
    if (all.back().area == 0.0) return std::nullopt;
    for (const Point2& point : outline) all.back().box.include(point);
  }
  std::vector<Surroundings> around;
  around.reserve(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    around.push_back(surroundingsOf(i, all));
    if (around.back().winding != (all[i].area > 0.0 ? 0 : 1)) return std::nullopt;
  }
  Regions regions;
  std::vector<std::size_t> region_of(all.size(), kNone);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].area < 0.0) continue;
    region_of[i] = regions.size();
    regions.push_back({std::move(outlines[i]), {}});
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].area < 0.0) regions[region_of[around[i].parent]].holes.push_back(std::move(outlines[i]));
  return regions;
}

}  // namespace lamina
