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

/// For each sample of a part, the number of layers that cover it. A layer covers a sample that lies between
/// its lower and upper side. The triangles of a bent layer are extruded into prisms that share their walls,
/// so that there are no gaps or overlaps at edges. A layer that folds back over itself counts several times.
/// @throws Cancelled if `progress` is cancelled
std::vector<std::uint32_t> layerCounts(const PartSamples& samples, const LayersToCount& layers,
                                       Progress& progress);

}  // namespace lamina
