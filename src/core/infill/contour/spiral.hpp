// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// One open spiral for each connected region, from the outside inwards: it follows each contour except for a
/// gap as wide as the distance to the next one, and there steps over to the next. All other contours, around
/// islands and in side branches, are joined to the spiral as in `contour`.
/// @throws InvalidInput if the spacing is not positive, or too small for the region
std::vector<FillPath> spiral(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
