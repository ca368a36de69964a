// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Fills regions solidly by a zigzag: strips parallel to the raster divide each evenly, a bead fills each
/// strip to its ends, as wide as the strip is there, and links along the border join them. Runs are in the
/// order of `raster.order`, from `request.start` on, region by region.
std::vector<FillPath> stripRuns(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
