// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/skins/skin_areas.hpp"

#include <algorithm>
#include <utility>

#include "geometry/polygon/divided_area.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

constexpr double kThinnest = 0.25;   // narrowest skins: walls three layers below are seen from about there on
constexpr double kLeastBeads = 4.0;  // squared bead widths: a smaller place is not worth a run of its own

Regions opened(const Regions& regions, double narrowest_mm) {
  if (regions.empty() || narrowest_mm == 0.0) return regions;
  return offset(offset(regions, -0.5 * narrowest_mm), 0.5 * narrowest_mm);
}

/// What of an area is not covered.
/// @param inside  the material of its layer
Regions uncovered(const Regions& inside, const SharedRegions& by, const LayerCover& cover) {
  return by == cover.material ? Regions{} : difference(inside, *by);
}

/// Grown beyond its border: into what is beside it, and into the walls.
Regions anchored(Regions wide, const SkinMeasures& measures) {
  if (wide.empty() || measures.anchor_mm == 0.0) return wide;
  return offset(wide, measures.anchor_mm);
}

/// Without slivers, and anchored.
Regions anchoredSkin(const Regions& regions, const SkinMeasures& measures) {
  return anchored(opened(regions, measures.narrowest_mm), measures);
}

Regions withoutSmall(Regions regions, double least_mm2) {
  const auto isSmall = [least_mm2](const Region& region) { return area({region}) < least_mm2; };
  regions.erase(std::remove_if(regions.begin(), regions.end(), isSmall), regions.end());
  return regions;
}

/// Where a bead closes what is too narrow for a skin.
/// @param wide  of what is open, what is a skin
Regions besideWalls(const Regions& open, const Regions& wide, const SkinMeasures& measures) {
  const double least_mm2 = kLeastBeads * measures.bead_mm * measures.bead_mm;
  if (measures.thinnest_mm == 0.0 || area(open) - area(wide) < measures.thinnest_mm * measures.bead_mm)
    return {};
  const Regions thin = opened(wide.empty() ? open : difference(open, wide), measures.thinnest_mm);
  return thin.empty() ? thin : withoutSmall(offset(thin, 0.5 * measures.bead_mm), least_mm2);
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
          hasSkins(skins) ? skins.least_infill_mm2 : 0.0,
          settings.walls.count > 0 && !isSolid(settings.infill)
              ? kThinnest * skins.narrowest * settings.bead.width_mm
              : 0.0,
          settings.bead.width_mm};
}

SkinAreas skinAreas(const Regions& inside, const LayerCover& cover, const SkinMeasures& measures) {
  SkinAreas areas;
  const Regions open = uncovered(inside, cover.whole, cover);
  const Regions wide = opened(open, measures.narrowest_mm);
  DividedArea found = divided(inside, anchored(wide, measures));
  const std::size_t parts = found.rest.size();
  areas.sparse = withoutSmall(std::move(found.rest), measures.least_infill_mm2);
  const Regions solid =
      areas.sparse.size() == parts ? std::move(found.common) : difference(inside, areas.sparse);
  if (!open.empty() && !areas.sparse.empty()) {
    DividedArea by_walls = divided(areas.sparse, besideWalls(open, wide, measures));
    areas.thickening = std::move(by_walls.common);
    areas.sparse = std::move(by_walls.rest);
  }
  if (solid.empty()) return areas;
  const auto seen = [&](const SharedRegions& from) {
    if (open.empty()) return Regions{};
    return anchoredSkin(from == cover.whole ? open : uncovered(inside, from, cover), measures);
  };
  DividedArea by_top = divided(solid, seen(cover.above));
  areas.top_skin = std::move(by_top.common);
  DividedArea by_bottom = divided(by_top.rest, seen(cover.below));
  areas.bottom_skin = std::move(by_bottom.common);
  areas.skin = std::move(by_bottom.rest);
  return areas;
}

bool hasSmall(const Regions& regions, double least_mm2) {
  return std::any_of(regions.begin(), regions.end(),
                     [least_mm2](const Region& region) { return area({region}) < least_mm2; });
}

}  // namespace lamina
