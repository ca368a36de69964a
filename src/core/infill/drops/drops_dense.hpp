// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Contours of drops, and inside them the drops of a hexagonal lattice with an edge of a pitch: rows of the
/// raster's direction, every other one shifted by half a pitch. One drop of the lattice lies at the origin.
/// @throws InvalidInput if a distance is not positive or too small for the regions
std::vector<FillPath> dropsDense(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
