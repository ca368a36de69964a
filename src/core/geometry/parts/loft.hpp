// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// The closed surface through rings of equally many points, bottom first, counter-clockwise seen from above.
/// Bottom and top are closed by strips that pair each ring's first half with its second half backwards, which
/// suits convex rings and bands that start and end at the same end.
Mesh loft(const std::vector<std::vector<Point3>>& rings);

/// A prism on z = 0 over a counter-clockwise outline that `loft` can close.
Mesh prism(const Polygon& outline, double height);

/// A pyramid on z = 0 over a counter-clockwise outline that `loft` can close.
Mesh pyramidOver(const Polygon& outline, const Point3& apex);

}  // namespace lamina
