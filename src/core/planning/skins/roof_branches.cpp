// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/skins/roof_branches.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "infill/lightning/branches.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/base/parallel.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/order/near_origin.hpp"
#include "planning/skins/skin_areas.hpp"
#include "planning/tools/tool_beads.hpp"
#include "planning/walls/infill_spacing.hpp"

namespace lamina {
namespace {

/// What the walls of a layer leave, shared out, that far from where it lies.
struct InsideWalls {
  Regions inside;
  Regions solid;
  Regions sparse;
  Point2 away = Point2::Zero();
};

double pitchOf(const PlanSettings& settings, double height_mm) {
  return settings.bead.pitch_mm > 0.0 ? settings.bead.pitch_mm
                                      : planWidth({settings.bead.width_mm, height_mm});
}

InsideWalls insideWalls(const LayerCover& at, const PlanSettings& settings, double pitch_mm,
                        StackPlace place) {
  InsideWalls within;
  if (place == StackPlace::AlongBelt) within.away = distanceFromOrigin(*at.material);
  const LayerCover cover = within.away.isZero() ? at : moved(at, -within.away);
  const double walls = wallThickness(settings, pitch_mm);
  within.inside = walls > 0.0 ? offset(*cover.material, -walls) : *cover.material;
  within.sparse = cover.isCovered()
                      ? within.inside
                      : skinAreas(within.inside, cover, skinMeasures(settings, pitch_mm)).sparse;
  if (!cover.isCovered()) within.solid = difference(within.inside, within.sparse);
  return within;
}

}  // namespace

std::vector<std::vector<Polyline>> branchesUnderSkins(const std::vector<LayerCover>& covers,
                                                      const std::vector<double>& heights_mm,
                                                      const PlanSettings& settings, StackPlace place,
                                                      Progress& progress) {
  if (covers.empty()) return {};
  std::vector<InsideWalls> within(covers.size());
  parallelFor(
      covers.size(),
      [&](std::size_t i) {
        within[i] = insideWalls(covers[i], settings, pitchOf(settings, heights_mm[i]), place);
      },
      progress, "skins");
  const double slope = std::tan(toRadians(settings.fill.lightning.angle_deg));
  std::vector<BranchLayer> layers(covers.size());
  const auto lay_roof = [&](std::size_t i) {
    const Point2& away = within[i].away;
    layers[i].inside = moved(within[i].inside, away);
    if (i + 1 < covers.size() && !within[i + 1].solid.empty())
      layers[i].roof =
          moved(intersection(moved(within[i + 1].solid, within[i + 1].away - away), within[i].sparse), away);
    layers[i].reach_mm = slope * heights_mm[std::min(i + 1, covers.size() - 1)];
  };
  parallelFor(covers.size(), lay_roof, progress, "skins");
  const double mean_mm =
      std::accumulate(heights_mm.begin(), heights_mm.end(), 0.0) / static_cast<double>(heights_mm.size());
  const RoleBead bead = beadOf(PathRole::Infill, settings, mean_mm);
  const auto outer = static_cast<std::size_t>(settings.infill.outer_layers);
  const InfillSpacing spacing = infillSpacing(settings.infill, bead.pitch_mm, {outer, 2 * outer + 1});
  return branchesUnderRoofs(layers, {spacing.spacing_mm, bead.bead.width_mm}, progress);
}

}  // namespace lamina
