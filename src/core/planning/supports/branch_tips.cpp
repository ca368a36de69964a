// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/supports/branch_tips.hpp"

#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

/// Of the spacing: tips are no nearer than the first, and places are tried at the second. So no place is
/// farther from a tip than a spacing: it is near a place tried, which is near a tip.
constexpr double kNearestTips = 0.6;
constexpr double kTried = 0.25;
constexpr double kClear = 0.01;  // mm: off the border of where a branch has room

/// Tips by their place, so that neighbours are found at once.
class TipGrid {
 public:
  explicit TipGrid(double cell_mm) : cell_(cell_mm) {}

  void add(const Point2& at, double height_mm) { cells_[keyOf(at)].emplace_back(at, height_mm); }

  /// Whether a tip of about that height is nearer than a cell.
  bool hasNear(const Point2& at, double height_mm) const {
    for (const double x : {-1.0, 0.0, 1.0})
      for (const double y : {-1.0, 0.0, 1.0}) {
        const auto found = cells_.find(keyOf(at + cell_ * Point2(x, y)));
        if (found == cells_.end()) continue;
        for (const auto& [tip, tip_height] : found->second)
          if ((tip - at).norm() < cell_ && std::abs(tip_height - height_mm) < cell_) return true;
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
  std::unordered_map<std::int64_t, std::vector<std::pair<Point2, double>>> cells_;
};

/// Along the outlines first, then on triangles within.
std::vector<Point2> placesIn(const Region& region, double step_mm) {
  std::vector<Point2> places;
  const std::vector<Polygon> borders = outlines({region});
  for (const Polygon& border : borders)
    for (std::size_t i = 0, j = border.size() - 1; i < border.size(); j = i++) {
      const double length = (border[i] - border[j]).norm();
      const auto pieces = static_cast<int>(std::ceil(length / step_mm));
      for (int k = 0; k < pieces; ++k)
        places.push_back(border[j] + static_cast<double>(k) / pieces * (border[i] - border[j]));
    }
  const Box2 box = boundingBox(borders);
  const double rise = step_mm * std::sqrt(0.75);
  for (auto row = static_cast<int>(std::floor(box.low.y() / rise)); row * rise <= box.high.y(); ++row) {
    const double shift = row % 2 == 0 ? 0.0 : 0.5 * step_mm;
    for (auto k = static_cast<int>(std::floor(box.low.x() / step_mm)) - 1; k * step_mm <= box.high.x(); ++k) {
      const Point2 place(k * step_mm + shift, row * rise);
      if (contains(borders, place)) places.push_back(place);
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

}  // namespace

std::vector<BranchTip> branchTips(const StackedMaterial& stack, const std::vector<Regions>& overhangs,
                                  const SupportSettings& settings) {
  const double spacing = settings.tip_spacing_mm;
  TipGrid grid(kNearestTips * spacing);
  std::vector<BranchTip> tips;
  for (std::size_t j = overhangs.size(); j-- > 0;) {
    if (overhangs[j].empty()) continue;
    const std::optional<ColumnTop> top = columnTopBelow(stack.bounds, j, settings.top_gap_mm);
    if (!top) continue;
    const std::size_t last = top->caps.empty() ? top->full_layers - 1 : top->caps.back().layer;
    const double reach = settings.side_gap_mm + 0.5 * settings.tip_mm + kClear;
    const Regions near_part = offset(within(*stack.material[last], boxOf(overhangs[j]), 3.0 * reach), reach);
    const double height = stack.bounds[j].bottom_mm;
    for (const Region& piece : overhangs[j])
      for (const Region& room : roomFor(piece, near_part, settings.tip_mm))
        for (const Point2& place : placesIn(room, kTried * spacing)) {
          if (grid.hasNear(place, height)) continue;
          grid.add(place, height);
          tips.push_back({place, j, *top});
        }
  }
  return tips;
}

}  // namespace lamina
