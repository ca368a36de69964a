// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "lamina/infill/fill_path.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/planning/skins/layer_cover.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Runs of one layer outside the part itself: supports, skirt, brim, raft or priming.
struct AidRuns {
  std::shared_ptr<const std::vector<FillPath>> runs;  ///< of nominal beads, in the plane of the layer
  Bead bead;
  double top_mm = 0.0;  ///< height of the nozzle tip
  RunOrder order = RunOrder::Shortest;
  std::uint32_t tool = 0;
  SharedRegions area;  ///< area over which travels need no retraction; null for none
};

/// The aids of a layer, in the order in which they are deposited before its islands.
using LayerAids = std::vector<AidRuns>;

/// The aids, moved in the plane of the layers [mm].
LayerAids moved(LayerAids aids, const Point2& by);

/// Volume that the runs deposit [mm³].
double depositedVolume(const AidRuns& aids);

}  // namespace lamina
