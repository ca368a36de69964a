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

/// The support of a layer by the one below, and how unsupported beads are deposited. A layer that equals the
/// one below costs nothing.
class LayerBelow {
 public:
  /// A support of everything: on the bed, and without `bridges.use` and `overhangs.use`.
  LayerBelow() = default;
  /// @param cover     null if everything is supported
  /// @param settings  must outlive this
  /// @param index     of the layer, from 0
  LayerBelow(const Layer& layer, const LayerCover* cover, const std::optional<BedPlane>& bed,
             const PlanSettings& settings, std::size_t index);

  /// Whether bridges are used, and part of the regions is unsupported.
  bool leavesGaps(const Regions& regions) const;

  /// Divides an area by what is below it.
  /// @param inside    area within the walls
  /// @param pitch_mm  distance of neighbouring beads
  BridgedAreas bridged(const Regions& inside, double pitch_mm) const;
  /// The same over other supporting material.
  BridgedAreas bridgedOver(const Regions& carrying, const Regions& inside, double pitch_mm) const;

  /// The path as it is deposited over the layer below: overhanging walls changed, others as they are.
  Path carried(Path path) const;

 private:
  const PlanSettings* settings_ = nullptr;
  std::size_t index_ = 0;
  std::optional<Regions> carrying_;
  std::optional<BorderDistance> border_;  ///< of that
};

}  // namespace lamina
