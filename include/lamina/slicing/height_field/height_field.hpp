// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/voxel/height_grid.hpp"
#include "lamina/parameterization/layer_surface.hpp"
#include "lamina/slicing/planar/layer_stack.hpp"

namespace lamina {

/// A mapping that bends level layers: a point at the height `z` above the bed moves to the height `z` times a
/// factor that depends on x and y alone. With the offset h = H (factor - 1) at the height H of the part in
/// level layers, the new height is
///
///     z (1 + h(x, y) / H)
///
/// So layers are flat on the bed, bend more the higher they are, and their thickness is scaled by the factor.
struct HeightField {
  HeightGrid cells;
  double base_mm = 0.0;  ///< z of the bed [part frame]
  /// Positive factors at the corners of the cells, row by row. In between they are interpolated linearly in
  /// the two triangles of a cell, which share the diagonal from its low to its high corner.
  std::vector<double> factor;

  /// Index of a cell's corner at its low x and y; there is one more row and column of corners than of cells.
  std::size_t corner(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cells.columns + 1) +
           static_cast<std::size_t>(column);
  }
  Point2 cornerPoint(int column, int row) const { return cells.origin + cells.cell_mm * Point2(column, row); }

  /// The factor at a point (x, y) [part frame]; outside the grid, the factor at the nearest point of its
  /// border.
  double factorAt(const Point2& plan) const;

  /// The point of the part to which a point of the level layers is bent.
  Point3 bent(const Point3& level) const;
  /// The inverse of `bent`.
  Point3 level(const Point3& bent) const;
};

/// The mesh with its vertices mapped by `HeightField::level`; its edges should be short compared with the
/// curvature of the bend.
Mesh levelled(Mesh mesh, const HeightField& field);

/// The chart of a bent layer over a rectangle of the xy plane, widened to whole cells. Its parameterization
/// is the projection to the xy plane; tips are vertically above their points, at the top of the layer;
/// normals are those of the middle of the layer.
/// @param bounds  bottom and top of the level layer
LayerChart bentLayer(const HeightField& field, const LayerBounds& bounds, const Box2& area);

}  // namespace lamina
