// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/voids/beads/void_map.hpp"

namespace lamina {

/// The voids of a layer without those between the lines of a sparse infill, and in a part that is hollow:
/// these are open on purpose. Such is a region within walls and skins that is open by more than a quarter,
/// and wide enough for two of the widest beads side by side (3.2 pitches). Sums of the layer stay as they
/// are.
/// @param found  of the layer, within the contour
/// @param contour  united; the deposit's frame [mm]
/// @throws InvalidInput as `findVoids`
LayerVoids withoutOpenInfill(LayerVoids found, const Regions& contour, const ToolpathLayer& layer,
                             const VoidMapSettings& settings);

}  // namespace lamina
