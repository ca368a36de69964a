// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Contours of drops, and inside them parallel lines a line spacing apart, to and fro. Along each line drops
/// lie evenly from end to end, as many as keep the pitch. One line passes through the origin.
/// @throws InvalidInput if a distance is not positive or too small for the regions
std::vector<FillPath> dropsRaster(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
