// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/bridges/hollow_below.hpp"

#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

constexpr double kLeastHollow = 3.0;  // narrowest skins: a bridge goes on over less, to what holds it

Regions wideParts(const Regions& regions, double width_mm) {
  return regions.empty() ? regions : offset(offset(regions, -0.5 * width_mm), 0.5 * width_mm);
}

}  // namespace

HollowBelow hollowBelow(const Regions& inside, const LayerCover& cover, const LayerCover& cover_below,
                        const SkinMeasures& measures) {
  const Regions below = skinAreas(inside, cover_below, measures).sparse;
  if (below.empty()) return {};
  const Regions here = skinAreas(inside, cover, measures).sparse;
  if (difference(below, here).empty()) return {};
  HollowBelow found;
  found.hollow = wideParts(intersection(below, here), kLeastHollow * measures.narrowest_mm);
  found.room = found.hollow.empty() ? inside : difference(inside, found.hollow);
  found.carrying = difference(*cover_below.material, below);
  return found;
}

}  // namespace lamina
