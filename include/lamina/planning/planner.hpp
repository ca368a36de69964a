// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/planning/bridges/bridge_settings.hpp"
#include "lamina/planning/left_open.hpp"
#include "lamina/planning/lift/layer_lift.hpp"
#include "lamina/planning/modifiers/plan_variant.hpp"
#include "lamina/planning/order/anchoring.hpp"
#include "lamina/planning/order/fill_starts.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/planning/skins/layer_cover.hpp"
#include "lamina/planning/supports/support_marks.hpp"
#include "lamina/slicing/layer.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Runs that fill voids between walls and infill (`voids.refill`).
struct Refilling {
  std::size_t runs = 0;
  double deposited_mm3 = 0.0;
};

/// Supported area and volume of supports; all 0 without supports.
struct SupportTotals {
  double overhang_mm2 = 0.0;  ///< overhangs by more than `supports.angle_deg`, of all layers
  /// Overhangs without supports: too narrow, or above the part with supports on the bed only.
  double unsupported_mm2 = 0.0;
  double blocked_mm2 = 0.0;  ///< further overhangs, which are marked to stay without support
  double area_mm2 = 0.0;     ///< greatest area of supports in a layer
  double support_mm3 = 0.0;  ///< volume of supports, without interfaces
  double interface_mm3 = 0.0;
  std::size_t dropped_branches = 0;  ///< branches without a foot
};

/// A toolpath with figures on what it leaves out and adds.
struct Plan {
  Toolpath toolpath;
  Refilling refilling;
  FillStarts starts;        ///< of all layers
  AnchoredStarts anchored;  ///< of all layers
  Bridging bridging;        ///< of all layers
  /// Volume that no bead or drop fills: too thin, left out whole by a solid fill, or without room on its
  /// layer.
  double unprinted_mm3 = 0.0;
  LeftOpen left_open;  ///< by solid fills in cells
  SupportTotals supports;
  double raft_mm = 0.0;  ///< height of the raft, which lies below the part; the part keeps its coordinates
};

/// The bed of a part with regions that have settings of their own.
struct VariedBed {
  Box2 bed;  ///< where the nozzle may be [mm, part frame]
  const std::vector<PlanVariant>& variants;
  const SupportMarks* marks = nullptr;  ///< null for none
  /// Areas in which walls that pass through them start, by layer; null or empty for none.
  const std::vector<Regions>* seams = nullptr;
};

/// The place of inclined layers: bed and rotation.
struct LayerIncline {
  BedPlane bed;
  Eigen::Quaterniond part_from_layers = Eigen::Quaterniond::Identity();
};

/// How layers that are planned flat are brought to their places in the part.
struct LayerLifting {
  LayerLift lift;
  /// For each layer, whether `skins.strategy` fills it solid, whatever the infill; empty: none.
  std::vector<bool> is_skin = {};
  /// Highest z of anything that stands on the bed before the first layer [mm, part frame].
  double standing_mm = -std::numeric_limits<double>::infinity();
  /// Cover of each layer, in the frame of its plan, by which skins close visible areas. The cover of a layer
  /// without skins has no material. Empty if no layer has skins. Only for settings with `takesSkins`.
  std::vector<LayerCover> covers = {};
};

/// The plan of a part, with the toolpath of `planToolpath`.
/// @throws as `planToolpath`
Plan planPart(const std::string& part_name, const std::vector<Layer>& layers, const PlanSettings& settings,
              Progress& progress);

/// The plan of a part in level layers over a bed.
/// @param bed  where the nozzle may be [mm, part frame]: brims end there, and prime lines lie along its edge
/// @throws as `planToolpath`; InvalidConfig if a prime line does not fit on the bed or would cross the part
Plan planPart(const std::string& part_name, const std::vector<Layer>& layers, const PlanSettings& settings,
              const Box2& bed, Progress& progress);

/// The plan of a part in level layers over a bed, with other settings in parts of the layers. Fills must
/// deposit beads, and must not continue from layer to layer.
/// @param layers  each is freed once it is planned: callers move large parts in
/// @throws as `planToolpath`; InvalidConfig if a strategy deposits drops or continues from layer to layer
Plan planPart(const std::string& part_name, std::vector<Layer> layers, const PlanSettings& settings,
              const VariedBed& varied, Progress& progress);

/// The plan of a part in inclined layers, in the frame of the layers. The plan has no skirt, as a skirt would
/// leave the bed. Runs start by `anchoring.strategy`.
/// @throws as `planToolpath`
Plan planPart(const std::string& part_name, const std::vector<Layer>& layers, const PlanSettings& settings,
              const LayerIncline& incline, Progress& progress);

/// The plan of a part whose layers are planned flat and lifted to their places. The plan has no skirt, no
/// bridges and no ironing. Overhanging walls are planned as other walls. Chained layers and travels between
/// layers are joined in space (`docs/slicing/lifting.md`). All figures describe the flat plans; only the
/// toolpath is lifted.
/// @param layers  the flat plans, with the heights of their beads
/// @throws as `planToolpath`, and what `lifting.lift` throws; InvalidConfig for strategies that rise from
///   layer to layer
Plan planPart(const std::string& part_name, const std::vector<Layer>& layers, const PlanSettings& settings,
              const LayerLifting& lifting, Progress& progress);

/// The toolpath of a part in planar layers: skirt, walls and infill of each layer, ordered for short travels
/// and joined by them. The nozzle points down; its tip runs at the top of each layer. A layer with an empty
/// section has no paths.
///
/// @param layers  ascending, in the part frame [mm]
/// @return satisfies `validate`; the same for any number of threads
/// @throws InvalidConfig if a setting is out of range or the strategy unknown; Cancelled; what a strategy
///   throws, with the place before its message: "layer 12 at 2.4 mm, island 3: ", both counted from 0
Toolpath planToolpath(const std::string& part_name, const std::vector<Layer>& layers,
                      const PlanSettings& settings, Progress& progress);

}  // namespace lamina
