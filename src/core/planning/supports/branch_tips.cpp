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
constexpr double kNearestOnRim = 0.45;  // the same along rims, where walls span from tip to tip
constexpr double kClear = 0.01;         // mm: off the border of where a branch has room
constexpr double kSameLayer = 1e-6;     // mm
constexpr double kRim = 0.05;           // mm, beside that border: where tips below ledges are

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

/// On triangles.
std::vector<Point2> placesWithin(const Region& region, double step_mm) {
  std::vector<Point2> places;
  const std::vector<Polygon> borders = outlines({region});
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

class TipSpread {
 public:
  TipSpread(const StackedMaterial& stack, const WallBeads& walls, const SupportSettings& settings)
      : stack_(stack),
        walls_(walls),
        settings_(settings),
        near_(kNearestTips * settings.tip_spacing_mm, kNearestTips * settings.tip_spacing_mm),
        rim_(kNearestOnRim * settings.tip_spacing_mm, kNearestTips * settings.tip_spacing_mm),
        beside_(kNearestTips * settings.tip_spacing_mm, kSameLayer) {}

  void holdUp(const Regions& overhang, std::size_t layer) {
    const std::optional<ColumnTop> top = columnTopBelow(stack_.bounds, layer, settings_.top_gap_mm);
    if (!top || overhang.empty()) return;
    const std::size_t last = top->caps.empty() ? top->full_layers - 1 : top->caps.back().layer;
    const double height = stack_.bounds[layer].bottom_mm;
    for (const Region& room : besideLedges(overhang, layer, last))
      for (const auto& places : {placesAlongRim(room, kTried * settings_.tip_spacing_mm),
                                 placesWithin(room, kTried * settings_.tip_spacing_mm)})
        for (const Point2& place : places)
          if (!beside_.hasNear(place, height)) add({place, layer, *top}, height);
    const double reach = settings_.side_gap_mm + radius() + kClear;
    const Regions near_part = offset(within(*stack_.material[last], boxOf(overhang), 3.0 * reach), reach);
    for (const Region& piece : overhang)
      for (const Region& room : roomFor(piece, near_part, settings_.tip_mm)) {
        for (const Point2& place : placesAlongRim(room, kTried * settings_.tip_spacing_mm))
          if (!rim_.hasNear(place, height)) add({place, layer, *top}, height);
        for (const Point2& place : placesWithin(room, kTried * settings_.tip_spacing_mm))
          if (!near_.hasNear(place, height)) add({place, layer, *top}, height);
      }
  }

  std::vector<BranchTip> tips() && { return std::move(tips_); }

 private:
  double radius() const { return 0.5 * settings_.tip_mm; }

  void add(BranchTip tip, double height_mm) {
    near_.add(tip.at, height_mm);
    rim_.add(tip.at, height_mm);
    beside_.add(tip.at, height_mm);
    tips_.push_back(std::move(tip));
  }

  /// Along the nearest places to the part that a tip may have: no part of it lies below a layer that is not
  /// held up by it.
  Regions besideLedges(const Regions& overhang, std::size_t layer, std::size_t last) const {
    const Regions ledges =
        ledgesIn(overhang, *stack_.material[layer], *stack_.material[last], walls_, settings_);
    if (ledges.empty()) return {};
    const double gap = ledgeGap(settings_) + kClear;
    const Box2 box = boxOf(ledges);
    Regions part;
    for (std::size_t k = last; k < layer; ++k) {
      const double reach = radius() + (k == last ? gap : kClear);
      part = united(part, offset(within(*stack_.material[k], box, 4.0 * reach), reach));
    }
    return intersection(difference(offset(part, kRim), part), offset(ledges, radius()));
  }

  const StackedMaterial& stack_;
  const WallBeads& walls_;
  const SupportSettings& settings_;
  TipGrid near_;
  TipGrid rim_;     ///< where walls hang
  TipGrid beside_;  ///< of one layer each
  std::vector<BranchTip> tips_;
};

}  // namespace

std::vector<BranchTip> branchTips(const StackedMaterial& stack, const std::vector<Regions>& overhangs,
                                  const WallBeads& walls, const SupportSettings& settings) {
  TipSpread spread(stack, walls, settings);
  for (std::size_t j = overhangs.size(); j-- > 0;) spread.holdUp(overhangs[j], j);
  return std::move(spread).tips();
}

}  // namespace lamina
