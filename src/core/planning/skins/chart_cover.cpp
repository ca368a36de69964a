// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/skins/chart_cover.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

#include "lamina/geometry/polygon/offset.hpp"

namespace lamina {
namespace {

constexpr double kFinest = 0.5;  // bead widths, from the middle of a patch to its corners
constexpr double kNear = 5.0;    // bead widths, between patches that follow each other
constexpr double kOverlap =
    1.02;  // of patches, over their size: without it rounding parts neighbours by slivers

/// A place in the middle of a layer.
struct SeenPlace {
  Point3 place = Point3::Zero();
  Point3 growth = Point3::Zero();  // to the same place of the next layer
  Point2 plan = Point2::Zero();
};

using Patch = std::array<SeenPlace, 3>;

SeenPlace between(const SeenPlace& a, const SeenPlace& b) {
  return {0.5 * (a.place + b.place), 0.5 * (a.growth + b.growth), 0.5 * (a.plan + b.plan)};
}

SeenPlace middleOf(const Patch& patch) {
  const auto& [a, b, c] = patch;
  return {(a.place + b.place + c.place) / 3.0, (a.growth + b.growth + c.growth) / 3.0,
          (a.plan + b.plan + c.plan) / 3.0};
}

Patch patchOf(const LayerChart& chart, const Triangle& corners) {
  Patch patch;
  for (std::size_t i = 0; i < patch.size(); ++i) {
    const Point3& middle = chart.surface.middle.vertices[corners[i]];
    patch[i] = {middle, 2.0 * (chart.surface.tip[corners[i]] - middle), chart.parameterization[corners[i]]};
  }
  return patch;
}

/// Side from corner i to the next that is longest.
std::size_t longestSide(const Patch& patch) {
  const auto length = [&patch](std::size_t i) {
    return (patch[(i + 1) % 3].place - patch[i].place).squaredNorm();
  };
  std::size_t longest = 0;
  for (std::size_t i = 1; i < patch.size(); ++i)
    if (length(i) > length(longest)) longest = i;
  return longest;
}

/// Where a layer is seen: patches of its plan, so small that each counts as its middle does. Most of a part
/// lies too deep in it for any to be needed.
class SeenPatches {
 public:
  /// @param inner  outlines of what lies within walls; must outlive this
  SeenPatches(const PartSpace& part, const SkinReach& reach, const std::vector<Polygon>& inner)
      : part_(part),
        reach_(reach),
        inner_(inner),
        sides_(part.sides, reach.below + 1 + reach.above, kNear * reach.bead_mm) {}

  void add(const Patch& patch) {
    const SeenPlace middle = middleOf(patch);
    double radius_mm = 0.0;
    double thickness_mm = middle.growth.norm();
    for (const SeenPlace& corner : patch) {
      radius_mm = std::max(radius_mm, (corner.place - middle.place).norm());
      thickness_mm = std::max(thickness_mm, corner.growth.norm());
    }
    const auto layers = static_cast<double>(std::max(reach_.above, reach_.below));
    const bool is_finest = radius_mm <= kFinest * reach_.bead_mm;
    if (is_finest && !contains(inner_, middle.plan)) return;
    if (!part_.surface.nearest(middle.place, radius_mm + layers * thickness_mm)) return;
    if (is_finest) return look(middle, patch);
    const std::size_t a = longestSide(patch);
    const std::size_t b = (a + 1) % 3;
    const SeenPlace split = between(patch[a], patch[b]);
    Patch half = patch;
    half[b] = split;
    add(half);
    half = patch;
    half[a] = split;
    add(half);
  }

  std::vector<Polygon> from_above;     ///< directly: the next layer is missing
  std::vector<Polygon> from_below;     ///< directly
  std::vector<Polygon> from_anywhere;  ///< a layer within reach is missing

 private:
  /// Patches follow each other, so that places as many layers off make a row.
  bool goesOn(const SeenPlace& middle, int layers) {
    const Point3 place = middle.place + static_cast<double>(layers) * middle.growth;
    return sides_.isWithin(place, reach_.below + static_cast<std::size_t>(layers));
  }

  /// Whether a layer from the second on is missing.
  bool endsWithin(const SeenPlace& middle, std::size_t layers, int sense) {
    for (std::size_t k = 2; k <= layers; ++k)
      if (!goesOn(middle, sense * static_cast<int>(k))) return true;
    return false;
  }

  void look(const SeenPlace& middle, const Patch& patch) {
    Polygon outline;
    outline.reserve(patch.size());
    for (const SeenPlace& corner : patch)
      outline.push_back(middle.plan + kOverlap * (corner.plan - middle.plan));
    const bool ends_above = reach_.above > 0 && !goesOn(middle, 1);
    const bool ends_below = reach_.below > 0 && !goesOn(middle, -1);
    if (ends_above) from_above.push_back(outline);
    if (ends_below) from_below.push_back(outline);
    if (ends_above || ends_below || endsWithin(middle, reach_.above, 1) ||
        endsWithin(middle, reach_.below, -1))
      from_anywhere.push_back(outline);
  }

  const PartSpace& part_;
  const SkinReach& reach_;
  const std::vector<Polygon>& inner_;
  RowSides sides_;  ///< by layers from the lowest that is looked at
};

/// The material but for the patches, whose seams and jags are closed.
SharedRegions without(const std::vector<Polygon>& patches, const SharedRegions& material, double jag_mm) {
  if (patches.empty()) return material;
  const Regions seen = offset(offset(unite(patches), jag_mm), -jag_mm);
  return std::make_shared<const Regions>(difference(*material, seen));
}

}  // namespace

LayerCover coverOnCharts(const std::vector<LayerChart>& charts, Regions material, const PartSpace& part,
                         const SkinReach& reach) {
  const double jag_mm = kFinest * reach.bead_mm;
  const std::vector<Polygon> inner = outlines(offset(material, jag_mm - reach.wall_mm));
  SeenPatches seen(part, reach, inner);
  for (const LayerChart& chart : charts)
    for (const Triangle& corners : chart.surface.middle.triangles) seen.add(patchOf(chart, corners));
  LayerCover cover;
  cover.material = std::make_shared<const Regions>(std::move(material));
  cover.above = without(seen.from_above, cover.material, jag_mm);
  cover.below = without(seen.from_below, cover.material, jag_mm);
  cover.whole = without(seen.from_anywhere, cover.material, jag_mm);
  return cover;
}

}  // namespace lamina
