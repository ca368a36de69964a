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

/// Bends level layers: what lies `z` above the bed goes to `z` times a factor that depends on the place in
/// the plan alone. With h = H (factor - 1), H the height of the part in level layers, that is
///
///     z (1 + h(x, y) / H)
///
/// so that layers are flat on the bed, bend more the higher they lie, and are as thick as the factor says.
struct HeightField {
  HeightGrid cells;
  double base_mm = 0.0;        ///< z of the bed [part frame]
  std::vector<double> factor;  ///< at the corners of the cells, row by row; positive. Linear in the two
                               ///< triangles of a cell, which meet along its rising diagonal

  /// Index of the corner at the low end of that cell; the grid has one more row and column than cells.
  std::size_t corner(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(cells.columns + 1) +
           static_cast<std::size_t>(column);
  }
  Point2 cornerPoint(int column, int row) const { return cells.origin + cells.cell_mm * Point2(column, row); }

  /// Beyond the grid that of its border.
  double factorAt(const Point2& plan) const;

  /// Where a point of the level layers lies in the part.
  Point3 bent(const Point3& level) const;
  /// The reverse.
  Point3 level(const Point3& bent) const;
};

/// The mesh with its vertices where they lie in level layers; its edges should be short against the bend.
Mesh levelled(Mesh mesh, const HeightField& field);

/// The chart of a layer over a rectangle of the plan, widened to whole cells: its plan is the xy plane, tips
/// lie straight above their plan at the layer's top, and normals are those of its middle.
LayerChart bentLayer(const HeightField& field, const LayerBounds& bounds, const Box2& area);

}  // namespace lamina
