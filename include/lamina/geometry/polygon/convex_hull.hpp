// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// The convex hull of points [Andrew1979]: its corners only, counter-clockwise. Empty if all points lie on
/// one line.
Polygon convexHull(std::vector<Point2> points);

}  // namespace lamina
