// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>

#include "lamina/planning/order/anchoring.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/planning/skins/layer_cover.hpp"
#include "lamina/slicing/layer.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/bridges/bridged_areas.hpp"
#include "planning/overhangs/border_distance.hpp"

namespace lamina {

/// The support of a layer by the one below, and how unsupported beads are deposited. A layer that equals the
/// one below costs nothing.
class LayerBelow {
 public:
  /// Everything is supported, as on the bed, or if neither `bridges.use` nor `overhangs.use` is set.
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
  /// Divides an area by what is below it, with `carrying` as the supporting material.
  BridgedAreas bridgedOver(const Regions& carrying, const Regions& inside, double pitch_mm) const;

  /// The path as deposited over the layer below: overhanging walls are changed, others are not.
  Path carried(Path path) const;

 private:
  const PlanSettings* settings_ = nullptr;
  std::size_t index_ = 0;
  std::optional<Regions> carrying_;
  std::optional<BorderDistance> border_;  ///< distance from the border of the supporting material
};

}  // namespace lamina
