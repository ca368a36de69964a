// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/planning/bridges/bridge_settings.hpp"
#include "lamina/planning/lift/layer_lift.hpp"
#include "lamina/planning/modifiers/plan_variant.hpp"
#include "lamina/planning/order/anchoring.hpp"
#include "lamina/planning/order/fill_starts.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/planning/supports/support_marks.hpp"
#include "lamina/slicing/layer.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Runs that fill what walls and infill leave open, `voids.refill`.
struct Refilling {
  std::size_t runs = 0;
  double deposited_mm3 = 0.0;
};

/// What is held up, and by how much material; all 0 without supports.
struct SupportTotals {
  double overhang_mm2 = 0.0;     ///< what hangs over by more than `supports.angle_deg`, of all layers
  double unsupported_mm2 = 0.0;  ///< of that: too narrow, or over the part where supports stand on the bed
  double blocked_mm2 = 0.0;      ///< overhangs besides, which are marked as not to be held up
  double area_mm2 = 0.0;         ///< of the layer with the most support
  double support_mm3 = 0.0;      ///< deposited, without interfaces
  double interface_mm3 = 0.0;
  std::size_t dropped_branches = 0;  ///< that found no foot
};

/// A toolpath, what it leaves out and what was added to it.
struct Plan {
  Toolpath toolpath;
  Refilling refilling;
  FillStarts starts;        ///< of all layers
  AnchoredStarts anchored;  ///< of all layers
  Bridging bridging;        ///< of all layers
  /// Of what gets no bead or drop: too thin, left out whole by a solid fill, or without room on its layer.
  double unprinted_mm3 = 0.0;
  SupportTotals supports;
  double raft_mm = 0.0;  ///< from the bed to the part, which keeps its coordinates: the raft lies below
};

/// The bed of a part whose layers have regions of their own settings.
struct VariedBed {
  Box2 bed;  ///< where the nozzle may be [mm, part frame]
  const std::vector<PlanVariant>& variants;
  const SupportMarks* marks = nullptr;  ///< null for none
};

/// How inclined layers stand.
struct LayerIncline {
  BedPlane bed;
  Eigen::Quaterniond part_from_layers = Eigen::Quaterniond::Identity();
};

/// The plan of a part, as `planToolpath` makes it.
/// @throws as it does
Plan planPart(const std::string& part_name, const std::vector<Layer>& layers, const PlanSettings& settings,
              Progress& progress);

/// The plan of a part in level layers over a bed.
/// @param bed  where the nozzle may be [mm, part frame]: brims end there, and prime lines lie along its edge
/// @throws as `planToolpath`; InvalidConfig if a prime line does not fit on the bed or would cross the part
Plan planPart(const std::string& part_name, const std::vector<Layer>& layers, const PlanSettings& settings,
              const Box2& bed, Progress& progress);

/// The same with other settings in part of the layers. Only fills of beads within a layer take that.
/// @throws as `planToolpath`; InvalidConfig if a strategy lays drops or goes on from layer to layer
Plan planPart(const std::string& part_name, const std::vector<Layer>& layers, const PlanSettings& settings,
              const VariedBed& varied, Progress& progress);

/// The plan of a part in inclined layers, in the frame of the layers: without skirt, which would leave the
/// bed, and with the starts of runs as `anchoring.strategy` says.
/// @throws as `planToolpath`
Plan planPart(const std::string& part_name, const std::vector<Layer>& layers, const PlanSettings& settings,
              const LayerIncline& incline, Progress& progress);

/// The plan of a part whose layers are planned in a plan each, and lifted to where they are deposited:
/// without skirt; chained layers and travels between layers are joined in space (`lifting.md`). What the plan
/// reports besides its toolpath is measured in the plans.
/// @param layers  the plans; their layers give the height that beads are planned with
/// @throws as `planToolpath`, and what `lift` throws; InvalidConfig for strategies that rise from layer to
///         layer
Plan planPart(const std::string& part_name, const std::vector<Layer>& layers, const PlanSettings& settings,
              const LayerLift& lift, Progress& progress);

/// The toolpath of a part cut into planar layers: skirt, walls and infill of each layer, ordered to shorten
/// travel and joined by travel paths. The nozzle points down; its tip runs at the top of each layer. Layers
/// whose section is empty stay in the toolpath without paths.
///
/// @param layers  ascending, in the part frame [mm]
/// @return satisfies `validate`; the same for any number of threads
/// @throws InvalidConfig if a setting is out of range or the strategy unknown; Cancelled; what a strategy
///   throws: its message then begins with the place, "layer 12 at 2.4 mm, island 3: ", both counted from 0
Toolpath planToolpath(const std::string& part_name, const std::vector<Layer>& layers,
                      const PlanSettings& settings, Progress& progress);

}  // namespace lamina
