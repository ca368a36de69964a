// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/region_triangulation.hpp"

namespace lamina {

/// Heights over a triangulated region that take given values on its border and satisfy Laplace's equation
/// inside, by linear finite elements.
/// @param border  height of each point of the border [mm]
/// @return height of each point of the region [mm]; between the lowest and the highest of the border
/// @throws InvalidInput if a triangle beside an inner point has no area
std::vector<double> harmonicHeights(const RegionTriangulation& region, const std::vector<double>& border);

}  // namespace lamina
