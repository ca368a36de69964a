// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/planning/compensation/compensation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

constexpr double kOverlap = 0.01;  // mm, by which places that stay run into those that shrink

double diameter(const Polygon& hole) { return 2.0 * std::sqrt(std::abs(signedArea(hole)) / M_PI); }

bool stays(const Polygon& hole, const CompensationSettings& settings) {
  return settings.least_hole_mm > 0.0 && diameter(hole) > settings.least_hole_mm;
}

/// The hole as an area of its own.
Region filled(const Polygon& hole) { return {{hole.rbegin(), hole.rend()}, {}}; }

Regions movedHoles(const Region& region, const CompensationSettings& settings) {
  Regions moved;
  Regions unmoved;
  for (const Polygon& hole : region.holes) (stays(hole, settings) ? unmoved : moved).push_back(filled(hole));
  if (settings.holes_mm != 0.0) moved = offset(moved, settings.holes_mm);
  moved.insert(moved.end(), unmoved.begin(), unmoved.end());
  return moved;
}

void append(std::vector<Polygon>& polygons, const Regions& regions) {
  for (Polygon& outline : outlines(regions)) polygons.push_back(std::move(outline));
}

}  // namespace

Regions compensated(const Regions& regions, const CompensationSettings& settings) {
  if (settings.outline_mm == 0.0 && settings.holes_mm == 0.0) return regions;
  std::vector<Polygon> parts;
  for (const Region& region : regions) {
    Regions whole = {{region.outer, {}}};
    if (settings.outline_mm != 0.0) whole = offset(whole, -settings.outline_mm);
    append(parts, region.holes.empty() ? whole : difference(whole, movedHoles(region, settings)));
  }
  return unite(parts);
}

Regions insetOnBed(const Regions& regions, double inset_mm, double bead_width_mm) {
  if (inset_mm == 0.0) return regions;
  const double least = 0.5 * bead_width_mm + inset_mm;
  const Regions core = offset(regions, -least);
  const Regions wide = offset(core, least);
  std::vector<Polygon> parts;
  append(parts, offset(core, least - inset_mm));
  // What is left besides narrow places is what rounding leaves along outlines.
  const Regions narrow = offset(offset(difference(regions, wide), -kOverlap), kOverlap);
  if (!narrow.empty()) append(parts, intersection(offset(narrow, inset_mm + kOverlap), regions));
  return unite(parts);
}

double insetOf(std::size_t layer, const FirstLayerSettings& settings) {
  const double share = static_cast<double>(layer) / static_cast<double>(settings.inset_layers);
  return share < 1.0 ? settings.inset_mm * (1.0 - share) : 0.0;
}

void compensate(std::vector<Layer>& layers, const CompensationSettings& settings,
                const FirstLayerSettings& first_layer, double bead_width_mm, Progress& progress) {
  const bool moves_outlines = settings.outline_mm != 0.0 || settings.holes_mm != 0.0;
  const std::size_t count =
      moves_outlines ? layers.size()
                     : std::min(layers.size(), first_layer.inset_mm == 0.0
                                                   ? std::size_t{0}
                                                   : static_cast<std::size_t>(first_layer.inset_layers));
  const auto change = [&](std::size_t i) {
    const Regions regions = compensated(unite(layers[i].section.contours), settings);
    layers[i].section.contours = outlines(insetOnBed(regions, insetOf(i, first_layer), bead_width_mm));
  };
  parallelFor(count, change, progress, "slice");
}

Point3 shrinkageFactors(const CompensationSettings& settings) {
  const double xy = 1.0 / (1.0 - settings.shrink_xy);
  return {xy, xy, 1.0 / (1.0 - settings.shrink_z)};
}

}  // namespace lamina
