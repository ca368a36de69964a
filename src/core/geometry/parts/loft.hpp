// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// The closed surface through rings with equally many points, bottom first, counter-clockwise seen from
/// above. Bottom and top are closed by strips that pair the first half of a ring with its second half in
/// reverse. This suits convex rings, and bands whose points start and end at the same end of the band.
Mesh loft(const std::vector<std::vector<Point3>>& rings);

/// A prism on z = 0 over a counter-clockwise outline of a kind that `loft` can close.
Mesh prism(const Polygon& outline, double height);

/// A pyramid on z = 0 over a counter-clockwise outline of a kind that `loft` can close.
Mesh pyramidOver(const Polygon& outline, const Point3& apex);

}  // namespace lamina
