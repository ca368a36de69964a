// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/bridges/layer_below.hpp"

#include <utility>

#include "planning/overhangs/carrying_area.hpp"
#include "planning/overhangs/overhanging_path.hpp"

namespace lamina {

LayerBelow::LayerBelow(const Layer& layer, const LayerCover* cover, const std::optional<BedPlane>& bed,
                       const PlanSettings& settings, std::size_t index)
    : settings_(&settings), index_(index) {
  const bool asks = settings.bridges.is_used || settings.overhangs.is_used;
  if (!asks || cover == nullptr || isCarried(*cover, bed, index)) return;
  carrying_ = carryingArea(layer, *cover, bed);
  border_.emplace(*carrying_, 0.75 * settings.bead.width_mm);
}

bool LayerBelow::leavesGaps(const Regions& regions) const {
  return carrying_ && settings_->bridges.is_used &&
         !overNothing(regions, *carrying_, settings_->bead.width_mm).empty();
}

BridgedAreas LayerBelow::bridged(const Regions& inside, double pitch_mm) const {
  return bridgedOver(*carrying_, inside, pitch_mm);
}

BridgedAreas LayerBelow::bridgedOver(const Regions& carrying, const Regions& inside, double pitch_mm) const {
  BridgeMeasures measures;
  measures.settings = settings_->bridges;
  measures.narrowest_mm = settings_->bead.width_mm;
  measures.thread_pitch_mm = threadPitch(settings_->bridges, settings_->bead.width_mm, pitch_mm);
  measures.fringe_mm = settings_->bead.width_mm + settings_->walls.count * pitch_mm;
  return bridgedAreas(inside, carrying, measures);
}

Path LayerBelow::carried(Path path) const {
  if (!border_ || kindOf(path.role) != RoleKind::Wall || path.deposit != Deposit::Bead) return path;
  OverhangRules rules;
  rules.walls = settings_->overhangs;
  rules.anchor_mm = settings_->bridges.anchor_mm;
  if (settings_->bridges.is_used) rules.bridge_feed_mm_s = settings_->feed.bridge_mm_s;
  return overhanging(std::move(path), *border_, rules, index_);
}

}  // namespace lamina
