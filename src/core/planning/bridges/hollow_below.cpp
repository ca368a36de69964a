// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/bridges/hollow_below.hpp"

#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {

HollowBelow hollowBelow(const Regions& inside, const LayerCover& cover, const LayerCover& cover_below,
                        const SkinMeasures& measures) {
  const Regions below = skinAreas(inside, cover_below, measures).sparse;
  if (below.empty()) return {};
  const Regions here = skinAreas(inside, cover, measures).sparse;
  if (difference(below, here).empty()) return {};
  HollowBelow found;
  found.hollow = intersection(below, here);
  found.room = found.hollow.empty() ? inside : difference(inside, found.hollow);
  found.carrying = difference(*cover_below.material, below);
  return found;
}

}  // namespace lamina
