// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/polygon/polygon.hpp>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

using GridPoint = boost::polygon::point_data<int>;
/// From low() to high(), the material on its left.
using GridSegment = boost::polygon::segment_data<int>;

/// The border of a region on a grid, as the Voronoi diagram needs it.
struct BorderSegments {
  Point2 origin = Point2::Zero();     ///< where the grid's (0, 0) is [mm]
  double units_per_mm = 1e5;          ///< of the grid
  std::vector<GridSegment> segments;  ///< meet at their ends only
};

/// Segments of no length are left out, and those that lie on each other: one way and back, in pairs.
/// @throws InvalidInput if the region is larger than 20 m
BorderSegments borderSegments(const Region& region);

}  // namespace lamina
