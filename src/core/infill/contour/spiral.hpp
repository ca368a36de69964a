// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// One open spiral per connected region, from the outside in: it goes round each contour but for a gap as
/// wide as the distance to the next one, and steps over there. Contours that do not lie on its way, round
/// islands and in side branches, are joined into it as in `contour`.
/// @throws InvalidInput if the spacing is not positive, or too small for the region
std::vector<FillPath> spiral(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
