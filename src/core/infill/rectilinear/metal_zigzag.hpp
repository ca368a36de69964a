// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// The zigzag of metal deposition inside perimeters as in [Flores2018, section 6.1.2]: gridSections, adapted
/// longitudinally and transversally; ordered by `raster.order`.
///
/// @param perimeters  areas bounded by the centre lines of perimeters
std::vector<FillPath> metalZigzag(const Regions& perimeters, const InfillRequest& request);

}  // namespace lamina
