// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Contours of drops, one inside the other until the regions are filled.
/// @throws InvalidInput if a distance between drops is not positive, or is too small for the regions
std::vector<FillPath> dropsContour(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
