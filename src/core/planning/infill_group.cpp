// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/infill_group.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

#include "lamina/base/angle.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/order/near_origin.hpp"
#include "planning/skins/skin_areas.hpp"

namespace lamina {
namespace {

Regions sparseOf(const LayerCover& cover, const PlanSettings& settings, double height_mm) {
  const double pitch_mm =
      settings.bead.pitch_mm > 0.0 ? settings.bead.pitch_mm : planWidth({settings.bead.width_mm, height_mm});
  const double walls_mm = wallThickness(settings, pitch_mm);
  const Regions inside = walls_mm > 0.0 ? offset(*cover.material, -walls_mm) : *cover.material;
  return cover.isCovered() ? inside : skinAreas(inside, cover, skinMeasures(settings, pitch_mm)).sparse;
}

/// Those of the first and last `infill.outer_layers`.
bool isOuter(std::size_t layer, std::size_t layers, const InfillSettings& infill) {
  const auto outer = static_cast<std::size_t>(infill.outer_layers);
  return layer < outer || layer + outer >= layers;
}

/// Layers of a stack, worked on that far from where they lie.
struct GroupStretch {
  std::size_t begin = 0;
  std::size_t end = 0;
  Point2 away = Point2::Zero();
};

/// What is sparse in all layers of a stretch, near the origin. Layers that are the same are looked at once.
Regions commonSparse(const std::vector<LayerCover>& covers, const std::vector<double>& heights_mm,
                     const PlanSettings& settings, const GroupStretch& stretch) {
  const std::size_t begin = stretch.begin;
  const std::size_t end = stretch.end;
  const Point2& away = stretch.away;
  for (std::size_t i = begin; i < end; ++i)
    if (isOuter(i, covers.size(), settings.infill)) return {};
  const auto sparse_in = [&](std::size_t i) {
    return sparseOf(away.isZero() ? covers[i] : moved(covers[i], -away), settings, heights_mm[i]);
  };
  Regions common = sparse_in(begin);
  for (std::size_t i = begin + 1; i < end; ++i) {
    const bool is_same = covers[i].material == covers[i - 1].material &&
                         covers[i].whole == covers[i - 1].whole && covers[i].isCovered() &&
                         heights_mm[i] == heights_mm[i - 1];
    if (!is_same && !common.empty()) common = intersection(common, sparse_in(i));
  }
  return common;
}

}  // namespace

std::size_t groupOf(const InfillSettings& settings, std::size_t layer) {
  return layer / static_cast<std::size_t>(settings.every_layers);
}

InfillRequest requestOf(const PlanSettings& settings, const InfillSpacing& spacing, std::size_t layer) {
  const InfillSettings& infill = settings.infill;
  InfillRequest request;
  request.pitch_mm = spacing.pitch_mm;
  request.spacing_mm = spacing.spacing_mm;
  const std::size_t turns = isSolid(spacing) ? layer : groupOf(infill, layer);
  const double turn_deg = infill.alternation_deg * static_cast<double>(turns);
  request.angle_rad = toRadians(std::fmod(infill.angle_deg + turn_deg, 360.0));
  request.turn_rad = toRadians(std::fmod(turn_deg, 360.0));
  request.layer = layer;
  request.links = infill.links;
  request.settings = settings.fill;
  return request;
}

GroupedInfill groupedInfill(const Regions& area, const InfillGroup& group, double bead_width_mm) {
  GroupedInfill parts;
  if (group.common->empty()) {
    parts.alone = area;
    return parts;
  }
  if (group.is_last) parts.together = intersection(area, *group.common);
  const Regions rest = difference(area, *group.common);
  if (!rest.empty()) parts.alone = offset(offset(rest, -0.5 * bead_width_mm), 0.5 * bead_width_mm);
  return parts;
}

std::vector<InfillGroup> infillGroups(const std::vector<LayerCover>& covers,
                                      const std::vector<double>& heights_mm, const PlanSettings& settings,
                                      StackPlace place, Progress& progress) {
  if (settings.infill.every_layers == 1) return {};
  const auto size = static_cast<std::size_t>(settings.infill.every_layers);
  std::vector<InfillGroup> groups(covers.size());
  const auto find = [&](std::size_t number) {
    const std::size_t begin = number * size;
    const std::size_t end = std::min(begin + size, covers.size());
    InfillGroup group;
    Point2 away = Point2::Zero();
    if (place == StackPlace::AlongBelt) away = distanceFromOrigin(*covers[begin].material);
    Regions common = commonSparse(covers, heights_mm, settings, {begin, end, away});
    if (!common.empty()) common = offset(common, settings.infill.wall_overlap * settings.bead.width_mm);
    group.common = std::make_shared<const Regions>(moved(std::move(common), away));
    const auto at = [&](std::size_t i) { return heights_mm.begin() + static_cast<std::ptrdiff_t>(i); };
    group.height_mm = std::accumulate(at(begin), at(end), 0.0);
    for (std::size_t i = begin; i < end; ++i) {
      groups[i] = group;
      groups[i].is_last = i + 1 == end;
    }
  };
  parallelFor((covers.size() + size - 1) / size, find, progress, "plan");
  return groups;
}

InfillGroup moved(const InfillGroup& group, const Point2& by) {
  return {std::make_shared<const Regions>(moved(*group.common, by)), group.is_last, group.height_mm};
}

}  // namespace lamina
