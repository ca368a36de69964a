// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/contour/parted_area.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "infill/medial/sharp_tips.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

/// Of the narrow rest, what is thinner than twice this is left out, in pitches.
constexpr double kHair = 0.1;

/// What is too small to hold a disc need not be shrunk to find that nothing is left.
Regions withRoomFor(Regions regions, double radius_mm) {
  const double least_area = M_PI * radius_mm * radius_mm;
  regions.erase(std::remove_if(regions.begin(), regions.end(),
                               [&](const Region& each) { return area({each}) < least_area; }),
                regions.end());
  return regions;
}

}  // namespace

PartedArea partByWidth(const Regions& area, double pitch_mm) {
  const Regions core = offset(area, -kCoreDepth * pitch_mm);
  if (core.empty()) return {{}, area};
  const Regions grown = offset(core, kCoreDepth * pitch_mm);
  // Rounding leaves hairs along the border: they are cleared away.
  const double hair_mm = kHair * pitch_mm;
  const Regions narrow = offset(withRoomFor(difference(area, grown), hair_mm), -hair_mm);
  if (narrow.empty()) return {area, {}};
  return {intersection(grown, area), offset(narrow, hair_mm)};
}

std::optional<PartedArea> partByTips(const Region& area, const Region& core, double pitch_mm) {
  std::optional<TipCut> cut = cutSharpTips(area, core, kCoreDepth * pitch_mm);
  if (!cut) return std::nullopt;
  const Regions narrow = offset(cut->tips, -kHair * pitch_mm);
  return PartedArea{{std::move(cut->rest)}, offset(narrow, kHair * pitch_mm)};
}

}  // namespace lamina
