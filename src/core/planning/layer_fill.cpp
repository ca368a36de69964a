// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/layer_fill.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "infill/contour/corner_smoothing.hpp"
#include "lamina/base/angle.hpp"
#include "lamina/geometry/polygon/offset.hpp"
#include "planning/infill_group.hpp"
#include "planning/run_path.hpp"
#include "planning/skins/ironing.hpp"
#include "planning/walls/walls.hpp"

namespace lamina {

LayerFill::LayerFill(const PlanContext& context, std::size_t index, double height_mm)
    : context_(context),
      index_(index),
      beads_(beadsByRole(context.settings, height_mm)),
      infill_(infillSpacing(context.settings.infill, beads_.infill.pitch_mm, {index, context.layer_count})) {}

bool LayerFill::isFitted() const { return context_.strategy.contact == WallContact::Fitted; }

bool LayerFill::depositsDrops() const { return context_.strategy.deposit == Deposit::Drops; }

bool LayerFill::isFilledByBeads() const {
  return !depositsDrops() && context_.strategy.link != LayerLink::Rising;
}

WallContact LayerFill::contact() const {
  if (isFittedAlone()) return WallContact::Beside;
  return isFitted() && !isSolid() ? WallContact::Overlapping : context_.strategy.contact;
}

double LayerFill::overlap() const {
  if (contact() != WallContact::Overlapping) return 0.0;
  return context_.settings.infill.wall_overlap * context_.settings.bead.width_mm;
}

bool LayerFill::isFittedAlone() const { return isSolid() && isFitted() && beads_.infill.pitch_mm != pitch(); }

Regions LayerFill::area(const Regions& inside) const {
  const double beyond = infill_.pitch_mm - beads_.infill.pitch_mm;
  if (context_.settings.walls.count > 0 || beyond == 0.0) return inside;
  return offset(inside, 0.5 * beyond);
}

InfillRequest LayerFill::request() const { return requestOf(context_.settings, infill_, index_); }

InfillRequest LayerFill::requestAs(PathRole role, InfillRequest request) const {
  if (beads_.of(role).pitch_mm != beads_.infill.pitch_mm)
    request.pitch_mm = request.spacing_mm = beads_.of(role).pitch_mm;
  return request;
}

InfillRequest LayerFill::skinRequest(InfillRequest request, double turn_deg) const {
  request.pitch_mm = request.spacing_mm = beads_.skins.pitch_mm;
  request.angle_rad = toRadians(context_.settings.skins.angle_deg + turn_deg);
  request.turn_rad = toRadians(turn_deg);
  return request;
}

std::vector<FillPath> LayerFill::infill(const Regions& area, const InfillRequest& request) const {
  if (area.empty()) return {};
  const SmoothingSettings& smoothing = context_.settings.fill.smoothing;
  std::vector<FillPath> fills = context_.strategy.fill(area, request);
  for (FillPath& fill : fills) {
    fill = simplified(smoothed(std::move(fill), smoothing), smoothing.tolerance_mm);
    for (double& width : fill.width_mm) width *= beads_.infill.pitch_mm / infill_.pitch_mm;
  }
  return fills;
}

SolidRuns LayerFill::solid(const Regions& area, PathRole role, InfillRequest request,
                           const InfillStrategy& strategy) const {
  if (area.empty()) return {};
  const PlanSettings& settings = context_.settings;
  const double pitch_mm = beads_.of(role).pitch_mm;
  FittedArea parts{area, {}};
  if (strategy.contact == WallContact::Fitted) parts = fitted(area, settings, pitch_mm);
  const bool goes_one_way = laysInOneSense(settings.skins, role);
  if (goes_one_way) request.advance = LineAdvance::OneSense;
  std::vector<FillPath> fills;
  if (!parts.wide.empty()) fills = strategy.fill(parts.wide, request);
  for (FillPath& fill : fills) {
    fill.role = role;
    for (double& width : fill.width_mm) width *= pitch_mm / request.pitch_mm;
    if (role != PathRole::Infill) fill = withoutShortMotions(std::move(fill), settings.bead.width_mm);
  }
  for (FillPath& narrow : parts.narrow) narrow.role = role;
  if (goes_one_way) return {std::move(fills), std::move(parts.narrow)};
  std::move(parts.narrow.begin(), parts.narrow.end(), std::back_inserter(fills));
  return {{}, std::move(fills)};
}

}  // namespace lamina
