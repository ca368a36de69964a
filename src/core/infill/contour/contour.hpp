// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// Contours parallel to the border, joined into one closed run for each connected region. Neighbouring
/// contours are cut open by a gap nearly as wide as their distance, and joined by two links across it.
/// @throws InvalidInput if the spacing is not positive, or too small for the region
std::vector<FillPath> contour(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
