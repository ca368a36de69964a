// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// The outline with fewer points, all taken from it [Douglas1973]: every point left out lies within
/// `tolerance_mm` of the edge that replaces it. It stays closed and keeps its direction.
///
/// @return fewer than three points, which are no outline, only if the whole outline lies within the tolerance
///   of one line; its area is then at most tolerance times perimeter
Polygon simplify(const Polygon& polygon, double tolerance_mm);

/// The outlines, each simplified by itself, without those that vanish. Outlines that are closer to each other
/// than twice the tolerance may cross afterwards.
std::vector<Polygon> simplify(const std::vector<Polygon>& polygons, double tolerance_mm);

}  // namespace lamina
