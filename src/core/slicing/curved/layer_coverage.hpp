// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/parameterization/layer_surface.hpp"
#include "lamina/slicing/layer.hpp"
#include "slicing/curved/part_samples.hpp"

namespace lamina {

/// Bent and level layers of one part.
struct LayersToCount {
  const std::vector<LayerSurface>& lower;
  const std::vector<Layer>& middle;
  const std::vector<LayerSurface>& upper;
};

/// How often each sample of a part is covered: by how many layers it is between whose lower and upper side
/// it lies. Of a bent layer every triangle fills the prism between both sides; prisms share their walls, so
/// that nothing is open or double where a layer bends. What folds back over itself counts as often as it
/// covers.
/// @throws Cancelled if `progress` is cancelled
std::vector<std::uint32_t> layerCounts(const PartSamples& samples, const LayersToCount& layers,
                                       Progress& progress);

}  // namespace lamina
