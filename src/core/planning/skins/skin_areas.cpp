// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/skins/skin_areas.hpp"

#include <algorithm>

#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

Regions opened(const Regions& regions, double narrowest_mm) {
  if (regions.empty() || narrowest_mm == 0.0) return regions;
  return offset(offset(regions, -0.5 * narrowest_mm), 0.5 * narrowest_mm);
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

/// What of an area is not covered.
Regions uncovered(const Regions& regions, const SharedRegions& cover) {
  return regions.empty() ? regions : difference(regions, near(*cover, boundingBox(outlines(regions))));
}

/// Without slivers, and grown into what is beside it.
Regions anchored(const Regions& regions, const Regions& inside, const SkinMeasures& measures) {
  Regions wide = opened(regions, measures.narrowest_mm);
  if (wide.empty() || measures.anchor_mm == 0.0) return wide;
  return intersection(offset(wide, measures.anchor_mm), inside);
}

Regions withoutSmall(Regions regions, double least_mm2) {
  const auto isSmall = [least_mm2](const Region& region) { return area({region}) < least_mm2; };
  regions.erase(std::remove_if(regions.begin(), regions.end(), isSmall), regions.end());
  return regions;
}

}  // namespace

double wallThickness(const PlanSettings& settings, double pitch_mm) {
  return settings.walls.count > 0 ? 0.5 * settings.bead.width_mm + (settings.walls.count - 0.5) * pitch_mm
                                  : 0.0;
}

SkinMeasures skinMeasures(const PlanSettings& settings, double pitch_mm) {
  const SkinSettings& skins = settings.skins;
  return {skins.narrowest * settings.bead.width_mm,
          skins.anchor_mm < 0.0 ? wallThickness(settings, pitch_mm) : skins.anchor_mm,
          hasSkins(skins) ? skins.least_infill_mm2 : 0.0};
}

SkinAreas skinAreas(const Regions& inside, const LayerCover& cover, const SkinMeasures& measures) {
  SkinAreas areas;
  const Regions open = cover.isCovered() ? Regions{} : uncovered(inside, cover.whole);
  const Regions skins = anchored(open, inside, measures);
  areas.sparse = withoutSmall(skins.empty() ? inside : difference(inside, skins), measures.least_infill_mm2);
  const Regions solid = areas.sparse.empty() ? inside : difference(inside, areas.sparse);
  if (solid.empty()) return areas;
  const Regions from_above = anchored(uncovered(open, cover.above), inside, measures);
  areas.top_skin = from_above.empty() ? Regions{} : intersection(from_above, solid);
  const Regions below_it = areas.top_skin.empty() ? solid : difference(solid, areas.top_skin);
  const Regions from_below = anchored(uncovered(open, cover.below), inside, measures);
  areas.bottom_skin = from_below.empty() ? Regions{} : intersection(from_below, below_it);
  areas.skin = areas.bottom_skin.empty() ? below_it : difference(below_it, areas.bottom_skin);
  return areas;
}

bool hasSmall(const Regions& regions, double least_mm2) {
  return std::any_of(regions.begin(), regions.end(),
                     [least_mm2](const Region& region) { return area({region}) < least_mm2; });
}

}  // namespace lamina
