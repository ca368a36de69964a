// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/voids/beads/void_points.hpp"

namespace lamina {

/// Vertices of the Voronoi diagram of the drops, in no particular order, some of them many times.
std::vector<VoidPoint> voronoiPoints(const std::vector<Point2>& drops);

}  // namespace lamina
