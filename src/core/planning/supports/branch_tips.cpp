// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/supports/branch_tips.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>

#include "geometry/spatial/edge_bands.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

/// Of the spacing: tips are no nearer than the first, and places are tried at the second. So no place is
/// farther from a tip than a spacing: it is near a place tried, which is near a tip.
constexpr double kNearestTips = 0.6;
constexpr double kTried = 0.25;
constexpr double kNearestOnRim = 0.45;     // the same along rims, where walls span from tip to tip
constexpr double kClear = 0.01;            // mm: off the border of where a branch has room
constexpr double kSameLayer = 1e-6;        // mm
constexpr double kBesideWall = 0.8;        // of a tip's radius, off the wall that it still holds up
constexpr std::size_t kLayersAtOnce = 64;  // in which places are sought before tips are spread

/// Tips by their place, so that neighbours are found at once.
class TipGrid {
 public:
  TipGrid(double cell_mm, double height_mm) : cell_(cell_mm), height_(height_mm) {}

  void add(const Point2& at, double height_mm) { cells_[keyOf(at)].emplace_back(at, height_mm); }

  /// Whether a tip of about that height is nearer aside than a cell.
  bool hasNear(const Point2& at, double height_mm) const {
    for (const double x : {-1.0, 0.0, 1.0})
      for (const double y : {-1.0, 0.0, 1.0}) {
        const auto found = cells_.find(keyOf(at + cell_ * Point2(x, y)));
        if (found == cells_.end()) continue;
        for (const auto& [tip, tip_height] : found->second)
          if ((tip - at).norm() < cell_ && std::abs(tip_height - height_mm) < height_) return true;
      }
    return false;
  }

 private:
  std::int64_t keyOf(const Point2& at) const {
    const auto column = static_cast<std::int64_t>(std::floor(at.x() / cell_));
    const auto row = static_cast<std::int64_t>(std::floor(at.y() / cell_));
    return column * 4000037 + row;
  }

  double cell_;
  double height_;
  std::unordered_map<std::int64_t, std::vector<std::pair<Point2, double>>> cells_;
};

std::vector<Point2> placesAlongRim(const Region& region, double step_mm) {
  std::vector<Point2> places;
  for (const Polygon& border : outlines({region}))
    for (std::size_t i = 0, j = border.size() - 1; i < border.size(); j = i++) {
      const double length = (border[i] - border[j]).norm();
      const auto pieces = static_cast<int>(std::ceil(length / step_mm));
      for (int k = 0; k < pieces; ++k)
        places.push_back(border[j] + static_cast<double>(k) / pieces * (border[i] - border[j]));
    }
  return places;
}

/// Where a level line crosses borders, in no order; a place on it is inside if an odd number lie to its
/// right.
std::vector<double> crossedAt(double y, const std::vector<BorderEdge>& edges) {
  std::vector<double> crossed;
  for (const auto& [from, to] : edges)
    if ((from.y() > y) != (to.y() > y))
      crossed.push_back(from.x() + (to.x() - from.x()) * (y - from.y()) / (to.y() - from.y()));
  return crossed;
}

/// On triangles.
std::vector<Point2> placesWithin(const Region& region, double step_mm) {
  std::vector<Point2> places;
  std::vector<BorderEdge> edges;
  Box2 box;
  forEachEdge(region, [&](const BorderEdge& edge) {
    edges.push_back(edge);
    box.include(edge.from);
  });
  const double rise = step_mm * std::sqrt(0.75);
  for (auto row = static_cast<int>(std::floor(box.low.y() / rise)); row * rise <= box.high.y(); ++row) {
    const std::vector<double> crossed = crossedAt(row * rise, edges);
    const double shift = row % 2 == 0 ? 0.0 : 0.5 * step_mm;
    for (auto k = static_cast<int>(std::floor(box.low.x() / step_mm)) - 1; k * step_mm <= box.high.x(); ++k) {
      const Point2 place(k * step_mm + shift, row * rise);
      const auto to_the_right =
          std::count_if(crossed.begin(), crossed.end(), [&](double x) { return place.x() < x; });
      if (to_the_right % 2 == 1) places.push_back(place);
    }
  }
  return places;
}

/// Where tips under a piece of overhang may be: their radius within it, if it is wide enough. Nowhere else if
/// there is room beside the part; below a wall that leans branches begin lower.
Regions roomFor(const Region& piece, const Regions& near_part, double tip_mm) {
  Regions inside = offset({piece}, -0.5 * tip_mm);
  if (inside.empty()) inside = {piece};
  Regions free = difference(inside, near_part);
  return free.empty() ? inside : free;
}

/// Places that tips below one layer may have, those to be tried first in front.
struct TriedPlaces {
  struct Room {
    std::vector<Point2> on_rim;
    std::vector<Point2> within;
  };
  std::optional<ColumnTop> top;  ///< none without room for any
  std::vector<Point2> below_walls;
  std::vector<Room> rooms;
};

/// Finds the places; what it finds for one layer does not depend on others.
class PlaceSearch {
 public:
  PlaceSearch(const StackedMaterial& stack, const WallBeads& walls, const SupportSettings& settings)
      : stack_(stack), walls_(walls), settings_(settings), step_(kTried * settings.tip_spacing_mm) {}

  TriedPlaces placesBelow(const Regions& overhang, std::size_t layer) const {
    TriedPlaces places;
    if (overhang.empty()) return places;
    places.top = columnTopBelow(stack_.bounds, layer, settings_.top_gap_mm);
    if (!places.top) return places;
    const ColumnTop& top = *places.top;
    const std::size_t last = top.caps.empty() ? top.full_layers - 1 : top.caps.back().layer;
    places.below_walls = placesBelowWalls(overhang, layer, last);
    const double reach = settings_.side_gap_mm + radius() + kClear;
    const Regions near_part = offset(within(*stack_.material[last], boxOf(overhang), 3.0 * reach), reach);
    for (const Region& piece : overhang)
      for (const Region& room : roomFor(piece, near_part, settings_.tip_mm))
        places.rooms.push_back({placesAlongRim(room, step_), placesWithin(room, step_)});
    return places;
  }

 private:
  double radius() const { return 0.5 * settings_.tip_mm; }

  /// Along the middle of the outer wall where it hangs, or between that and the next one, or as near to there
  /// as a tip may be; beside ledges first.
  std::vector<Point2> placesBelowWalls(const Regions& overhang, std::size_t layer, std::size_t last) const {
    const Regions hanging = hangingWalls(overhang, *stack_.material[layer], walls_);
    if (hanging.empty()) return {};
    const double gap = settings_.side_gap_mm;
    const Regions ledges = nearPart(hanging, *stack_.material[last], gap + 0.5 * radius(), walls_);
    std::vector<Point2> places;
    if (!ledges.empty()) places = placesAlongWall(ledges, layer, last, ledgeGap(settings_));
    const std::vector<Point2> others = placesAlongWall(hanging, layer, last, gap);
    places.insert(places.end(), others.begin(), others.end());
    return places;
  }

  /// No part of a tip there lies below a layer that is not held up by it.
  std::vector<Point2> placesAlongWall(const Regions& hanging, std::size_t layer, std::size_t last,
                                      double gap_mm) const {
    const Box2 box = boxOf(hanging);
    const double within_wall = 0.5 * std::min(walls_.thickness_mm, 2.0 * walls_.width_mm);
    Regions taken = offset(within(*stack_.material[layer], box, 4.0 * walls_.width_mm), -within_wall);
    for (std::size_t k = last; k < layer; ++k) {
      const double reach = radius() + (k == last ? gap_mm : 0.0) + kClear;
      taken = united(taken, offset(within(*stack_.material[k], box, 4.0 * reach), reach));
    }
    const EdgeBands near(offset(hanging, kBesideWall * radius()));
    std::vector<Point2> places;
    for (const Region& region : taken)
      for (const Point2& place : placesAlongRim(region, step_))
        if (near.enclose(place)) places.push_back(place);
    return places;
  }

  const StackedMaterial& stack_;
  const WallBeads& walls_;
  const SupportSettings& settings_;
  double step_;
};

class TipSpread {
 public:
  explicit TipSpread(double spacing_mm)
      : near_(kNearestTips * spacing_mm, kNearestTips * spacing_mm),
        rim_(kNearestOnRim * spacing_mm, kNearestTips * spacing_mm),
        walls_(kNearestOnRim * spacing_mm, kSameLayer) {}

  void holdUp(const TriedPlaces& tried, std::size_t layer, double height_mm) {
    if (!tried.top) return;
    const auto tryAll = [&](const std::vector<Point2>& places, const TipGrid& grid) {
      for (const Point2& place : places)
        if (!grid.hasNear(place, height_mm)) add({place, layer, *tried.top}, height_mm);
    };
    tryAll(tried.below_walls, walls_);
    for (const TriedPlaces::Room& room : tried.rooms) {
      tryAll(room.on_rim, rim_);
      tryAll(room.within, near_);
    }
  }

  std::vector<BranchTip> tips() && { return std::move(tips_); }

 private:
  void add(BranchTip tip, double height_mm) {
    near_.add(tip.at, height_mm);
    rim_.add(tip.at, height_mm);
    walls_.add(tip.at, height_mm);
    tips_.push_back(std::move(tip));
  }

  TipGrid near_;
  TipGrid rim_;
  TipGrid walls_;  ///< of one layer each
  std::vector<BranchTip> tips_;
};

}  // namespace

std::vector<BranchTip> branchTips(const StackedMaterial& stack, const std::vector<Regions>& overhangs,
                                  const WallBeads& walls, const SupportSettings& settings) {
  const PlaceSearch search(stack, walls, settings);
  TipSpread spread(settings.tip_spacing_mm);
  for (std::size_t end = overhangs.size(); end > 0; end -= std::min(end, kLayersAtOnce)) {
    const std::size_t count = std::min(end, kLayersAtOnce);
    std::vector<TriedPlaces> tried(count);
    parallelFor(count,
                [&](std::size_t k) { tried[k] = search.placesBelow(overhangs[end - 1 - k], end - 1 - k); });
    for (std::size_t k = 0; k < count; ++k)
      spread.holdUp(tried[k], end - 1 - k, stack.bounds[end - 1 - k].bottom_mm);
  }
  return std::move(spread).tips();
}

}  // namespace lamina
