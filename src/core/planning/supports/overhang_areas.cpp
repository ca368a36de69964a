// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/supports/overhang_areas.hpp"

#include <cmath>
#include <utility>

#include "lamina/base/angle.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "planning/supports/piecewise.hpp"

namespace lamina {
namespace {

constexpr int kTipSides = 16;
constexpr double kTouching = 1e-3;  // mm

/// Round the point, of the area of the disc.
Polygon disc(const Point2& middle, double diameter_mm) {
  const double step = 2.0 * M_PI / kTipSides;
  const double radius = 0.5 * diameter_mm * std::sqrt(step / std::sin(step));
  Polygon polygon;
  for (int i = 0; i < kTipSides; ++i)
    polygon.push_back(middle + radius * Point2(std::cos(i * step), std::sin(i * step)));
  return polygon;
}

Point2 middleOf(const Polygon& polygon) {
  Point2 sum = Point2::Zero();
  for (const Point2& point : polygon) sum += point;
  return sum / static_cast<double>(polygon.size());
}

double lengthAround(const Polygon& polygon) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum += (polygon[(i + 1) % polygon.size()] - polygon[i]).norm();
  return sum;
}

/// That of a strip of the same area and outline.
double meanWidth(const Region& piece) {
  double around = 0.0;
  for (const Polygon& border : outlines({piece})) around += lengthAround(border);
  return around > 0.0 ? 2.0 * area({piece}) / around : 0.0;
}

bool hangsOnNothing(const Region& piece, const Regions& below) {
  const Regions reach = offset({piece}, kTouching);
  return intersection(reach, within(below, boxOf(reach), kTouching)).empty();
}

/// Adds a tip below each piece that hangs on nothing and is too small for a support: a disc below a point,
/// a strip as wide below an edge.
Regions withTips(Regions overhang, const Regions& below, const SupportSettings& settings) {
  std::vector<Polygon> tips;
  const double tip = settings.tip_mm;
  for (const Region& piece : overhang) {
    const double width = meanWidth(piece);
    const bool is_small = area({piece}) <= tip * tip;
    if ((!is_small && width >= tip) || !hangsOnNothing(piece, below)) continue;
    if (boxOf({piece}).size().norm() > tip && width < tip) {
      for (Polygon& strip : outlines(offset({piece}, 0.5 * (tip - width)))) tips.push_back(std::move(strip));
    } else {
      tips.push_back(disc(middleOf(piece.outer), tip));
    }
  }
  if (tips.empty()) return overhang;
  return united(overhang, unite(tips));
}

}  // namespace

Regions overhangOf(const Regions& layer, const Regions& below, double lean_mm) {
  if (lean_mm <= 0.0) return difference(layer, below);
  const Regions beyond = differenceByPieces(layer, grownByPieces(below, lean_mm));
  if (beyond.empty()) return {};
  const Box2 box = boxOf(beyond);
  const Regions grown = intersection(grownByPieces(beyond, lean_mm), within(layer, box, 4.0 * lean_mm));
  return difference(grown, within(below, box, 4.0 * lean_mm));
}

Regions toHoldUp(const Regions& overhang, const Regions& held) {
  return overhang.empty() || held.empty() ? overhang : difference(overhang, held);
}

Regions heldByBridges(const Regions& overhang, const Regions& below, const HoldingBridges& bridges) {
  Regions held;
  for (const Region& piece : overhang) {
    const double reach = 2.0 * bridges.search.anchor_mm + bridges.search.pitch_mm;
    const BridgeDirection threads =
        bridgeDirection(piece, within(below, boxOf({piece}), reach), bridges.search);
    const bool is_short = bridges.longest_mm == 0.0 || threads.span_mm <= bridges.longest_mm;
    if (threads.held >= bridges.search.least_held && is_short) held.push_back(piece);
  }
  return held;
}

std::vector<Regions> overhangAreas(const StackedMaterial& stack, const SupportSettings& settings,
                                   Progress& progress, const std::optional<HoldingBridges>& bridges) {
  std::vector<Regions> overhangs(stack.size());
  const double lean = std::tan(toRadians(settings.angle_deg));
  const auto find = [&](std::size_t i) {
    if (i == 0 || stack.material[i] == stack.material[i - 1]) return;
    const Regions below = united(*stack.material[i - 1], stack.bedIn(i - 1));
    const Regions hangs = overhangOf(*stack.material[i], below, lean * stack.bounds[i].height());
    if (hangs.empty()) return;
    const Regions held = bridges ? heldByBridges(hangs, below, *bridges) : Regions{};
    overhangs[i] = withTips(toHoldUp(hangs, held), below, settings);
  };
  parallelFor(stack.size(), find, progress, "supports");
  return overhangs;
}

}  // namespace lamina
