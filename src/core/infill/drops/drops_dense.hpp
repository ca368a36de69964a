// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Contours of drops, and inside them the points of a hexagonal lattice whose edge is a pitch: rows in the
/// direction of the raster, every other one shifted by half a pitch. The origin is a point of the lattice.
/// @throws InvalidInput if a distance between drops is not positive, or is too small for the regions
std::vector<FillPath> dropsDense(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
