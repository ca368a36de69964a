// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// A place on an outline: on the way from point `segment` of it to the one after that.
struct OutlinePlace {
  std::size_t outline = 0;
  std::size_t segment = 0;
  double fraction = 0.0;
};

/// Triangles that fill an area of the plane without overlap, counter-clockwise.
struct RegionTriangulation {
  std::vector<Point2> points;        ///< those of the border first [mm]
  std::vector<OutlinePlace> border;  ///< where on the outlines each point of the border is
  std::vector<Triangle> triangles;
};

/// Delaunay triangles of an area with points inside about `step_mm` apart. The outlines are edges of it;
/// where they come close to each other or turn sharply, they are divided further. Time is n log n.
///
/// @param outlines  simple, apart from each other; material on their left
/// @throws InvalidInput if an outline has fewer than three points or still is no edge after having been
///         divided ten times, as where it crosses itself
RegionTriangulation triangulated(const std::vector<Polygon>& outlines, double step_mm);

}  // namespace lamina
