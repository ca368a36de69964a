// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/planning/planner.hpp"
#include "planning/adhesion/raft.hpp"
#include "planning/build_aids.hpp"
#include "planning/layer_planner.hpp"
#include "planning/supports/regional_overhangs.hpp"

namespace lamina {

/// The build aids of a part.
struct PlannedAids {
  std::vector<LayerAids> layers;  ///< one per layer of the part; empty without aids
  std::vector<RaftLayer> raft;    ///< layers below the part, from the bed up
  double raft_mm = 0.0;           ///< height from the bed to the part
  SupportTotals supports;
  /// Supports below each inclined layer, carried up to it along gravity; empty without these.
  std::vector<Regions> carrying;
};

/// Takes away the first layers of an inclined stack that hold neither part nor support.
void dropEmptyBelow(std::vector<Layer>& layers, PlannedAids& aids);

/// The sum of totals of different layers. The greatest area of supports in a layer is the greater one of
/// both.
SupportTotals sumOf(const SupportTotals& a, const SupportTotals& b);

/// Plans the build aids: supports and brim of layers in parallel planes; skirt, raft and prime line of level
/// layers. Lifted layers and parts of drops have none.
/// @param layers           in the frame of the layers
/// @param support_regions  regions with other settings of supports
/// @throws InvalidConfig if a prime line has no room; InvalidInput if there are such regions in layers far
/// out on a belt
PlannedAids planAids(const std::vector<Layer>& layers, const PlanContext& context,
                     const SupportRegions& support_regions, Progress& progress);

}  // namespace lamina
