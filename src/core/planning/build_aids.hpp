// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "lamina/infill/fill_path.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/skins/layer_cover.hpp"

namespace lamina {

/// Runs of one layer that lay what is no part of the part: supports, skirt, brim, raft, priming.
struct AidRuns {
  std::shared_ptr<const std::vector<FillPath>> runs;  ///< of nominal beads, in the plane of the layer
  Bead bead;
  double top_mm = 0.0;  ///< of the nozzle tip
  RunOrder order = RunOrder::Shortest;
  std::uint32_t tool = 0;
  SharedRegions area;  ///< over which travels need not be retracted; null for none
};

/// What is laid before the islands of a layer, in this order.
using LayerAids = std::vector<AidRuns>;

/// The same elsewhere in the plane of the layers.
LayerAids moved(LayerAids aids, const Point2& by);

/// Volume of what they lay [mm³].
double depositedVolume(const AidRuns& aids);

}  // namespace lamina
