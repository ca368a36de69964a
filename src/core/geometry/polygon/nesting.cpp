// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/polygon/nesting.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>

namespace lamina {
namespace {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

struct Outline {
  const Polygon* points;
  Box2 box;
  double area;
};

/// What lies round an outline: how often it is wound round, and the smallest that does.
struct Surroundings {
  int winding = 0;
  std::size_t parent = kNone;
};

bool isNestedIn(const Outline& outline, const Point2& point) {
  return (point - outline.box.low).minCoeff() >= 0.0 && (outline.box.high - point).minCoeff() >= 0.0 &&
         encloses(*outline.points, point);
}

/// The outline indices in ascending order of a height of each.
template <typename Height>
std::vector<std::size_t> fromBelow(const std::vector<Outline>& all, Height height) {
  std::vector<std::pair<double, std::size_t>> order;
  order.reserve(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) order.emplace_back(height(all[i]), i);
  std::sort(order.begin(), order.end());
  std::vector<std::size_t> indices;
  indices.reserve(order.size());
  for (const auto& each : order) indices.push_back(each.second);
  return indices;
}

/// Of one outline among those whose height range holds its first point.
Surroundings surroundingsOf(std::size_t of, const std::vector<std::size_t>& beside,
                            const std::vector<Outline>& all) {
  Surroundings result;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t i : beside) {
    if (i == of || !isNestedIn(all[i], all[of].points->front())) continue;
    result.winding += all[i].area > 0.0 ? 1 : -1;
    const double size = std::abs(all[i].area);
    if (std::tie(size, i) >= std::tie(least, result.parent)) continue;
    least = size;
    result.parent = i;
  }
  return result;
}

/// Of all outlines, from below upwards, so that each is compared with those beside it only.
std::vector<Surroundings> surroundings(const std::vector<Outline>& all) {
  const std::vector<std::size_t> entering = fromBelow(all, [](const Outline& o) { return o.box.low.y(); });
  const std::vector<std::size_t> asking =
      fromBelow(all, [](const Outline& o) { return o.points->front().y(); });
  std::vector<Surroundings> around(all.size());
  std::vector<std::size_t> beside;
  std::size_t entered = 0;
  for (const std::size_t i : asking) {
    const double y = all[i].points->front().y();
    beside.erase(std::remove_if(beside.begin(), beside.end(),
                                [&](std::size_t other) { return all[other].box.high.y() < y; }),
                 beside.end());
    for (; entered < entering.size() && all[entering[entered]].box.low.y() <= y; ++entered)
      if (all[entering[entered]].box.high.y() >= y) beside.push_back(entering[entered]);
    around[i] = surroundingsOf(i, beside, all);
  }
  return around;
}

}  // namespace

std::optional<Regions> nest(std::vector<Polygon> outlines) {
  std::vector<Outline> all;
  all.reserve(outlines.size());
  for (const Polygon& outline : outlines) {
    all.push_back({&outline, {}, signedArea(outline)});
    if (all.back().area == 0.0) return std::nullopt;
    for (const Point2& point : outline) all.back().box.include(point);
  }
  const std::vector<Surroundings> around = surroundings(all);
  for (std::size_t i = 0; i < all.size(); ++i)
    if (around[i].winding != (all[i].area > 0.0 ? 0 : 1)) return std::nullopt;
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
