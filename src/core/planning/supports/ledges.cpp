// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/supports/ledges.hpp"

#include <algorithm>

#include "lamina/geometry/polygon/offset.hpp"
#include "planning/supports/piecewise.hpp"
#include "planning/supports/stacked_material.hpp"

namespace lamina {
namespace {

// Bead widths.
constexpr double kHanging = 0.75;  // of a bead: less, and it lies on the layer below
constexpr double kLongest = 3.0;   // of a stretch that stays where it is without a support
constexpr double kDetail = 0.4;    // by which outlines of columns are simplified

/// What the walls of a layer enclose, within a box and somewhat beyond.
Regions insideOf(const Regions& layer, const Box2& box, const WallBeads& walls) {
  return offset(within(layer, box, 3.0 * walls.thickness_mm), -walls.thickness_mm);
}

Regions withoutShort(Regions pieces, const WallBeads& walls) {
  const auto isShort = [&](const Region& piece) {
    return boxOf({piece}).size().norm() < kLongest * walls.width_mm;
  };
  pieces.erase(std::remove_if(pieces.begin(), pieces.end(), isShort), pieces.end());
  return pieces;
}

}  // namespace

double ledgeGap(const SupportSettings& settings) {
  return std::min(settings.side_gap_mm, settings.top_gap_mm);
}

double ledgeStep(const WallBeads& walls) { return 0.5 * walls.width_mm; }

Regions hangingWalls(const Regions& overhang, const Regions& layer, const WallBeads& walls) {
  if (overhang.empty() || walls.thickness_mm <= 0.0) return {};
  const Regions wide = withoutNarrow(overhang, kHanging * walls.width_mm);
  if (wide.empty()) return {};
  return withoutShort(differenceByPieces(wide, insideOf(layer, boxOf(wide), walls)), walls);
}

Regions nearPart(const Regions& hanging, const Regions& below, double distance_mm, const WallBeads& walls) {
  const Regions near = within(below, boxOf(hanging), 3.0 * distance_mm);
  return withoutShort(intersection(hanging, grownByPieces(near, distance_mm)), walls);
}

Regions ledgesIn(const Regions& overhang, const Regions& layer, const Regions& below, const WallBeads& walls,
                 const SupportSettings& settings) {
  const double gap = settings.side_gap_mm;
  if (overhang.empty() || walls.thickness_mm <= 0.0 || ledgeGap(settings) >= gap) return {};
  const double width = walls.width_mm;
  const Regions wide = withoutNarrow(overhang, kHanging * width);
  if (wide.empty()) return {};
  const Box2 box = boxOf(wide);
  const Regions ledges = withoutShort(intersection(differenceByPieces(wide, insideOf(layer, box, walls)),
                                                   grownByPieces(within(below, box, 3.0 * gap), gap)),
                                      walls);
  if (ledges.empty()) return {};
  const double column = gap + std::max(width, settings.least_width_mm) + kDetail * width;
  const Regions narrow = difference(ledges, withoutNarrow(overhang, column));
  return narrow.empty() ? ledges : united(ledges, grownByPieces(narrow, column - kHanging * width));
}

}  // namespace lamina
