// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// The outline with fewer points, all of them its own [Douglas1973]: every point left out lies
/// within `tolerance_mm` [mm] of the edge that replaces it. Stays closed and keeps its winding.
///
/// @return fewer than three points, hence no outline, only if all of it lies within the tolerance of one
///         line; its area is then at most tolerance times perimeter
Polygon simplify(const Polygon& polygon, double tolerance_mm);

/// The outlines simplified one by one, without those that vanish. Outlines nearer to each other than twice
/// the tolerance may then cross.
std::vector<Polygon> simplify(const std::vector<Polygon>& polygons, double tolerance_mm);

}  // namespace lamina
