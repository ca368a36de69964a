// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/voids/beads/void_map.hpp"

namespace lamina {

/// The voids of a layer without those that are intended: between the lines of a sparse infill, and in a
/// hollow part. Voids are intended in a region inside walls and skins that is wide enough for two of the
/// widest beads side by side (3.2 pitches), if they cover more than a quarter of it. The sums of the layer,
/// such as `uncovered_mm2`, remain unchanged.
/// @param found  result of `findVoids` for the layer
/// @param contour  of the layer, without overlaps [mm, frame of the toolpath]
/// @throws InvalidInput as `findVoids`
LayerVoids withoutOpenInfill(LayerVoids found, const Regions& contour, const ToolpathLayer& layer,
                             const VoidMapSettings& settings);

}  // namespace lamina
