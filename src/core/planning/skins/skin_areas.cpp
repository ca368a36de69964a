// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/skins/skin_areas.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

Regions opened(const Regions& regions, double narrowest_mm) {
  if (regions.empty() || narrowest_mm == 0.0) return regions;
  return offset(offset(regions, -0.5 * narrowest_mm), 0.5 * narrowest_mm);
}

Regions united(const Regions& a, const Regions& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  std::vector<Polygon> all = outlines(a);
  for (Polygon& polygon : outlines(b)) all.push_back(std::move(polygon));
  return unite(all);
}

/// Those of the regions that may touch an area: a whole layer costs more than the island it is asked for.
Regions near(const Regions& regions, const Box2& box) {
  Regions found;
  for (const Region& region : regions) {
    const Box2 own = boundingBox({region.outer});
    if (!own.isEmpty() && (own.low.array() <= box.high.array()).all() &&
        (box.low.array() <= own.high.array()).all())
      found.push_back(region);
  }
  return found;
}

/// What of the area is not covered, without slivers.
class Uncovered {
 public:
  Uncovered(const Regions& inside, const LayerCover& cover, const SkinMeasures& measures)
      : inside_(inside),
        material_(cover.material),
        box_(boundingBox(outlines(inside))),
        measures_(measures) {}

  Regions by(const SharedRegions& cover) const {
    if (cover == material_) return {};
    return opened(difference(inside_, near(*cover, box_)), measures_.narrowest_mm);
  }
  /// Grown into what is beside it.
  Regions anchored(const Regions& regions) const {
    if (regions.empty()) return {};
    if (measures_.anchor_mm == 0.0) return regions;
    return intersection(offset(regions, measures_.anchor_mm), inside_);
  }

 private:
  const Regions& inside_;
  SharedRegions material_;
  Box2 box_;
  const SkinMeasures& measures_;
};

Regions withoutSmall(Regions regions, double least_mm2) {
  const auto isSmall = [least_mm2](const Region& region) { return area({region}) < least_mm2; };
  regions.erase(std::remove_if(regions.begin(), regions.end(), isSmall), regions.end());
  return regions;
}

}  // namespace

SkinAreas skinAreas(const Regions& inside, const LayerCover& cover, const SkinMeasures& measures) {
  SkinAreas areas;
  const Uncovered uncovered(inside, cover, measures);
  const Regions seen =
      uncovered.anchored(united(uncovered.by(cover.wholly_above), uncovered.by(cover.wholly_below)));
  areas.sparse = withoutSmall(seen.empty() ? inside : difference(inside, seen), measures.least_infill_mm2);
  const Regions solid = areas.sparse.empty() ? inside : difference(inside, areas.sparse);
  if (solid.empty()) return areas;
  const Regions from_above = uncovered.anchored(uncovered.by(cover.above));
  areas.top_skin = from_above.empty() ? Regions{} : intersection(from_above, solid);
  const Regions below_it = areas.top_skin.empty() ? solid : difference(solid, areas.top_skin);
  const Regions from_below = uncovered.anchored(uncovered.by(cover.below));
  areas.bottom_skin = from_below.empty() ? Regions{} : intersection(from_below, below_it);
  areas.skin = areas.bottom_skin.empty() ? below_it : difference(below_it, areas.bottom_skin);
  return areas;
}

}  // namespace lamina
