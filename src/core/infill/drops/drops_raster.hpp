// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Contours of drops, and inside them parallel lines a line spacing apart, to and fro. The drops of a line
/// are evenly spaced from end to end, in the greatest number that is at least the pitch apart. One line
/// passes through the origin.
/// @throws InvalidInput if a distance between drops is not positive, or is too small for the regions
std::vector<FillPath> dropsRaster(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
