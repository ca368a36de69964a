// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "lamina/infill/strategy.hpp"
#include "lamina/planning/lift/layer_lift.hpp"
#include "lamina/planning/order/anchoring.hpp"
#include "lamina/planning/order/fill_starts.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/planning/planner.hpp"
#include "lamina/planning/skins/layer_cover.hpp"
#include "lamina/slicing/layer.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/build_aids.hpp"
#include "planning/infill_group.hpp"

namespace lamina {

/// The context that all layers of a plan share.
struct PlanContext {
  PlanSettings settings;
  InfillStrategy strategy;
  InfillStrategy skin_strategy;
  std::size_t layer_count = 0;
  Point2 anchor = Point2::Zero();  ///< place of aligned seams, and start of each layer's order [mm]
  std::optional<BedPlane> bed;     ///< below inclined layers
  std::optional<Box2> level_bed;   ///< area of the nozzle over the bed of level layers, if known
  /// Pose of the layers' frame; the identity except for inclined layers.
  Eigen::Isometry3d part_from_layers = Eigen::Isometry3d::Identity();
  LayerLift lift;  ///< of layers that are planned flat; empty for others
  /// Of lifted layers: whether each is solid regardless of the infill; empty if none is.
  std::vector<bool> is_skin;
  /// Highest z of solid material on the bed before the first layer [mm, part frame].
  double standing_mm = -std::numeric_limits<double>::infinity();
};

/// The settings and the area of a variant of the plan in one layer (`PlanVariant`).
struct LayerVariant {
  const PlanContext* context = nullptr;
  const LayerCover* cover = nullptr;  ///< as `StackedLayer::cover`
  const LayerCover* cover_below = nullptr;
  const std::vector<Polyline>* branches = nullptr;
  const Regions* area = nullptr;
};

/// A layer and the one below it, if there is one.
struct StackedLayer {
  const Layer* layer = nullptr;
  const Layer* below = nullptr;
  const LayerCover* cover = nullptr;        ///< null unless skins, bridges or overhanging walls are used
  const LayerCover* cover_below = nullptr;  ///< of the layer below
  /// Branches of a fill that grows from the layers above; null for other fills.
  const std::vector<Polyline>* branches = nullptr;
  const InfillGroup* group = nullptr;       ///< null if each layer has an infill of its own
  const LayerAids* aids = nullptr;          ///< deposited first, except supports; null for none
  const Regions* supports = nullptr;        ///< below an inclined layer, carried up to it; null for none
  std::vector<LayerVariant> variants = {};  ///< variants with an area in this layer
  const Regions* seams = nullptr;           ///< areas for seams (`Seam`); null for none
};

/// The paths of one layer.
struct PlannedLayer {
  ToolpathLayer layer;
  double unprinted_mm2 = 0.0;  ///< area without bead or drop
  Refilling refilling;
  FillStarts starts;
  std::size_t moved_starts = 0;  ///< see `AnchoredStarts`
  double left_out_mm3 = 0.0;     ///< see `LiftedLayer`
  Bridging bridging = {};
  LeftOpen left_open = {};
};

/// Plans the paths of one layer, in order and joined by travels. The result depends on the arguments alone,
/// so that layers can be planned in parallel. An inclined layer starts at the bed, and its runs are anchored
/// on the layer before.
/// @param index  of the layer, from 0: sets the direction of infill; layer 0 is slower
/// @throws what strategies throw, with the place
PlannedLayer planLayer(const StackedLayer& stacked, std::size_t index, const PlanContext& context);

}  // namespace lamina
