// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/adhesion/adhesion_settings.hpp"
#include "lamina/slicing/planar/layer_stack.hpp"
#include "planning/build_aids.hpp"

namespace lamina {

/// A straight bead along the front or left edge of the bed. It starts at the corner, one bead width inside
/// both edges.
/// @param layer     the lowest one
/// @param bed       where the nozzle may be [mm]
/// @param occupied  area of everything else in that layer
/// @throws InvalidConfig if the bed is shorter than the line, or the line crosses `occupied`
AidRuns makePrimeLine(const PrimeSettings& settings, const LayerBounds& layer, const Box2& bed,
                      const Regions& occupied);

}  // namespace lamina
