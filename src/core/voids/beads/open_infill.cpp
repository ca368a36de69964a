// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/voids/beads/open_infill.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

/// Of a region within walls and skins: solid fills leave a few percent of theirs, sparse ones most of it.
constexpr double kMostOpen = 0.25;
/// In pitches.
constexpr double kTwoWidestBeads = 3.2;

/// What walls and skins leave, where it is wide enough for infill.
struct InfillRegion {
  Regions outline;
  Box2 box;
  double area_mm2 = 0.0;
};

std::vector<InfillRegion> infillRegions(const Regions& contour, const ToolpathLayer& layer, double pitch_mm,
                                        const VoidMapSettings& settings) {
  ToolpathLayer around{layer.z_mm, layer.height_mm, {}};
  std::copy_if(layer.paths.begin(), layer.paths.end(), std::back_inserter(around.paths),
               [](const Path& path) { return path.role != PathRole::Infill; });
  std::vector<InfillRegion> regions;
  for (const Void& each : findVoids(contour, around, settings).voids) {
    InfillRegion region{unite(outlines({each.outline})), boundingBox({each.outline.outer}), each.area_mm2};
    if (!offset(region.outline, -0.5 * kTwoWidestBeads * pitch_mm).empty())
      regions.push_back(std::move(region));
  }
  return regions;
}

bool liesIn(const Void& inner, const InfillRegion& region) {
  const Box2 box = boundingBox({inner.outline.outer});
  if ((box.low.array() > region.box.high.array()).any() || (region.box.low.array() > box.high.array()).any())
    return false;
  return area(intersection(unite(outlines({inner.outline})), region.outline)) > 0.5 * inner.area_mm2;
}

/// Of all voids, where those of the region stand.
std::vector<std::size_t> placesIn(const InfillRegion& region, const std::vector<Void>& voids) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < voids.size(); ++i)
    if (liesIn(voids[i], region)) places.push_back(i);
  return places;
}

}  // namespace

LayerVoids withoutOpenInfill(LayerVoids found, const Regions& contour, const ToolpathLayer& layer,
                             const VoidMapSettings& settings) {
  if (found.voids.empty()) return found;
  std::vector<bool> is_meant(found.voids.size(), false);
  for (const InfillRegion& region : infillRegions(contour, layer, found.pitch_mm, settings)) {
    const std::vector<std::size_t> places = placesIn(region, found.voids);
    double open_mm2 = 0.0;
    for (const std::size_t i : places) open_mm2 += found.voids[i].area_mm2;
    if (open_mm2 <= kMostOpen * region.area_mm2) continue;
    for (const std::size_t i : places) is_meant[i] = true;
  }
  std::vector<Void> kept;
  kept.reserve(found.voids.size());
  for (std::size_t i = 0; i < is_meant.size(); ++i)
    if (!is_meant[i]) kept.push_back(std::move(found.voids[i]));
  found.voids = std::move(kept);
  return found;
}

}  // namespace lamina
