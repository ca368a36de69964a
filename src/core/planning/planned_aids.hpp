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

/// What is laid beside a part, and holds it.
struct PlannedAids {
  std::vector<LayerAids> layers;  ///< as many as the part has; none if there are no aids at all
  std::vector<RaftLayer> raft;    ///< below these, from the bed up
  double raft_mm = 0.0;           ///< from the bed to the part
  SupportTotals supports;
};

/// Of both, whose layers are others: the layer with the most support is that of one of them.
SupportTotals sumOf(const SupportTotals& a, const SupportTotals& b);

/// Supports of layers in parallel planes; skirt, brim, raft and prime line of level ones. Lifted layers have
/// none, parts of drops neither.
/// @param layers           in the frame of the layers
/// @param support_regions  where supports are asked for otherwise
/// @throws InvalidConfig if a prime line has no room; InvalidInput if there are such regions in layers far
/// out
///   on a belt
PlannedAids planAids(const std::vector<Layer>& layers, const PlanContext& context,
                     const SupportRegions& support_regions, Progress& progress);

}  // namespace lamina
