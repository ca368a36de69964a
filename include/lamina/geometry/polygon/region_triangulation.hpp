// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// A position on an outline: between point `segment` of it and the next one.
struct OutlinePlace {
  std::size_t outline = 0;  ///< index of the outline
  std::size_t segment = 0;  ///< index of the point before
  double fraction = 0.0;    ///< share of the distance to the next point, 0 to 1
};

/// Counter-clockwise triangles that fill an area of the plane without overlap.
struct RegionTriangulation {
  std::vector<Point2> points;        ///< [mm]; those on the border first
  std::vector<OutlinePlace> border;  ///< position on the outlines of each point on the border
  std::vector<Triangle> triangles;
};

/// Triangulates an area (Delaunay), with points inside at distances of about `step_mm`. The outlines become
/// edges of triangles; they are divided further where they come close to each other or turn sharply. Time is
/// n log n.
///
/// @param outlines  simple, not touching each other; material on their left. A point may be given several
///   times in a row, and a line may be gone out and back, as where a section goes through vertices of a mesh.
/// @throws InvalidInput if an outline has fewer than three points, or a piece of it is still no edge after
///   ten divisions, as where it crosses itself
RegionTriangulation triangulated(const std::vector<Polygon>& outlines, double step_mm);

}  // namespace lamina
