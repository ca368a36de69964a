// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/supports/piecewise.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "geometry/polygon/edge_collapse_inset.hpp"
#include "geometry/polygon/plane_vectors.hpp"
#include "geometry/spatial/edge_bands.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "planning/supports/stacked_material.hpp"

namespace lamina {
namespace {

bool comeWithin(const Box2& a, const Box2& b, double distance_mm) {
  return ((a.low - b.high).array() <= distance_mm).all() && ((b.low - a.high).array() <= distance_mm).all();
}

Box2 boxRound(const Polygon& polygon) {
  Box2 box;
  for (const Point2& point : polygon) box.include(point);
  return box;
}

struct BoxedRegion {
  const Region* region;
  Box2 box;
};

std::vector<BoxedRegion> boxed(const Regions& regions) {
  std::vector<BoxedRegion> result;
  result.reserve(regions.size());
  for (const Region& region : regions) result.push_back({&region, boxRound(region.outer)});
  return result;
}

constexpr double kRounding = 1e-4;  // mm: of offsets
constexpr double kReach = 1.0;      // mm: beyond the box of what is clipped

/// From a point to the nearest outline.
double clearance(const Region& region, const Point2& point) {
  double nearest = std::numeric_limits<double>::infinity();
  forEachEdge(region, [&](const BorderEdge& edge) {
    nearest = std::min(nearest, (nearestOnSegment(edge.from, edge.to, point) - point).squaredNorm());
  });
  return std::sqrt(nearest);
}

Polygon reversed(const Polygon& polygon) { return {polygon.rbegin(), polygon.rend()}; }

/// By shrinking what is round the region, and its holes; none where outlines would meet.
std::optional<std::vector<Polygon>> grownBorders(const Region& region, double distance_mm) {
  std::vector<Polygon> borders;
  const Box2 box = boxRound(region.outer);
  const Point2 low = box.low - Point2::Constant(4.0 * distance_mm + kReach);
  const Point2 high = box.high + Point2::Constant(4.0 * distance_mm + kReach);
  const Region around{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}, {reversed(region.outer)}};
  const std::optional<Region> shrunk = insetByEdgeCollapse(around, distance_mm);
  if (!shrunk || shrunk->holes.size() != 1) return std::nullopt;
  borders.push_back(reversed(shrunk->holes.front()));
  for (const Polygon& hole : region.holes) {
    if (boxRound(hole).size().minCoeff() <= 2.0 * distance_mm) continue;
    const std::optional<Region> left = insetByEdgeCollapse({reversed(hole), {}}, distance_mm);
    if (!left) return std::nullopt;
    borders.push_back(reversed(left->outer));
  }
  return borders;
}

enum class Place { Outside, Inside, Across };

/// Where a piece lies of regions.
Place placeOf(const Region& piece, const EdgeBands& bands, const Regions& regions) {
  bool are_apart = true;
  forEachEdge(piece, [&](const BorderEdge& edge) { are_apart = are_apart && bands.areApartFrom(edge); });
  if (!are_apart) return Place::Across;
  const std::vector<Polygon> own = outlines({piece});
  const Box2 box = boxRound(piece.outer);
  const auto isWithin = [&](const Polygon& border) {
    const Point2& point = border.front();
    return (point.array() > box.low.array()).all() && (point.array() < box.high.array()).all() &&
           contains(own, point);
  };
  for (const Region& region : regions)
    if (isWithin(region.outer) || std::any_of(region.holes.begin(), region.holes.end(), isWithin))
      return Place::Across;
  return bands.enclose(piece.outer.front()) ? Place::Inside : Place::Outside;
}

}  // namespace

Regions differenceByPieces(const Regions& regions, const Regions& subtracted) {
  if (regions.empty() || subtracted.empty()) return regions;
  const EdgeBands bands(subtracted);
  Regions result;
  Regions across;
  for (const Region& piece : regions) {
    const bool is_near = comeWithin(boxRound(piece.outer), bands.box(), 0.0);
    const Place place = is_near ? placeOf(piece, bands, subtracted) : Place::Outside;
    if (place == Place::Outside) result.push_back(piece);
    if (place == Place::Across) across.push_back(piece);
  }
  if (across.empty()) return result;
  Regions clipped = difference(across, within(subtracted, boxOf(across), kReach));
  std::move(clipped.begin(), clipped.end(), std::back_inserter(result));
  return result;
}

Regions grownByPieces(const Regions& regions, double distance_mm) {
  std::vector<Polygon> moved;
  for (const Region& region : regions) {
    if (std::optional<std::vector<Polygon>> borders = grownBorders(region, distance_mm)) {
      // An outline alone does not meet itself.
      if (regions.size() == 1 && borders->size() == 1) return {{std::move(borders->front()), {}}};
      std::move(borders->begin(), borders->end(), std::back_inserter(moved));
      continue;
    }
    std::vector<Polygon> borders = outlines(offset({region}, distance_mm));
    std::move(borders.begin(), borders.end(), std::back_inserter(moved));
  }
  return unite(moved);
}

NeighbouringRegions neighbouring(const Regions& regions, double distance_mm) {
  const std::vector<BoxedRegion> all = boxed(regions);
  std::vector<bool> is_near(all.size(), false);
  std::vector<std::size_t> from_left(all.size());
  std::iota(from_left.begin(), from_left.end(), std::size_t{0});
  std::sort(from_left.begin(), from_left.end(), [&all](std::size_t a, std::size_t b) {
    return std::make_pair(all[a].box.low.x(), a) < std::make_pair(all[b].box.low.x(), b);
  });
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::size_t i = from_left[k];
    for (const Polygon& hole : all[i].region->holes)
      if (boxRound(hole).size().minCoeff() < distance_mm) is_near[i] = true;
    const double reach_mm = all[i].box.high.x() + distance_mm;
    for (std::size_t m = k + 1; m < all.size() && all[from_left[m]].box.low.x() <= reach_mm; ++m) {
      const std::size_t j = from_left[m];
      if (comeWithin(all[i].box, all[j].box, distance_mm)) is_near[i] = is_near[j] = true;
    }
  }
  NeighbouringRegions groups;
  for (std::size_t i = 0; i < all.size(); ++i)
    (is_near[i] ? groups.near : groups.alone).push_back(regions[i]);
  return groups;
}

bool surelyHasRoom(const Region& region, double radius_mm) {
  constexpr int kTried = 5;  // level lines
  const Box2 box = boxRound(region.outer);
  if (box.size().minCoeff() < 2.0 * radius_mm) return false;
  for (int i = 1; i <= kTried; ++i) {
    const double y = box.low.y() + box.size().y() * i / (kTried + 1);
    std::vector<double> crossings;
    forEachEdge(region, [&](const BorderEdge& edge) {
      if ((edge.from.y() > y) == (edge.to.y() > y)) return;
      const double share = (y - edge.from.y()) / (edge.to.y() - edge.from.y());
      crossings.push_back(edge.from.x() + share * (edge.to.x() - edge.from.x()));
    });
    std::sort(crossings.begin(), crossings.end());
    Point2 middle = Point2::Zero();
    double widest = 2.0 * radius_mm;
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2)
      if (crossings[k + 1] - crossings[k] > widest) {
        widest = crossings[k + 1] - crossings[k];
        middle = {0.5 * (crossings[k] + crossings[k + 1]), y};
      }
    if (widest > 2.0 * radius_mm && clearance(region, middle) > radius_mm + kRounding) return true;
  }
  return false;
}

}  // namespace lamina
