// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "lamina/planning/order/anchoring.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/slicing/layer.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/bridges/bridged_areas.hpp"
#include "planning/overhangs/border_distance.hpp"
#include "planning/skins/layer_cover.hpp"

namespace lamina {

/// What carries a layer, and how beads are laid that it does not carry. A layer that is the same as the one
/// below costs nothing.
class LayerBelow {
 public:
  /// Carries everything: without `bridges.use` and `overhangs.use`, and on the bed.
  LayerBelow() = default;
  /// @param cover     null if everything is carried
  /// @param settings  must outlive this
  /// @param index     of the layer, from 0
  LayerBelow(const Layer& layer, const LayerCover* cover, const std::optional<BedPlane>& bed,
             const PlanSettings& settings, std::size_t index);

  /// Whether bridges are asked for, and part of the regions lies over nothing.
  bool leavesGaps(const Regions& regions) const;

  /// @param inside    walls
  /// @param pitch_mm  at which beads are laid side by side
  BridgedAreas bridged(const Regions& inside, double pitch_mm) const;
  /// The same over other material.
  BridgedAreas bridgedOver(const Regions& carrying, const Regions& inside, double pitch_mm) const;

  /// A path as it is laid over the layer below: walls where they overhang, others as they are.
  Path carried(Path path) const;

 private:
  const PlanSettings* settings_ = nullptr;
  std::size_t index_ = 0;
  std::optional<Regions> carrying_;
  std::optional<BorderDistance> border_;  ///< of that
};

}  // namespace lamina
