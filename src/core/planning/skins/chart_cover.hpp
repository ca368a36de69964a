// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/geometry/spatial/nearest_triangle.hpp"
#include "lamina/parameterization/layer_surface.hpp"
#include "lamina/planning/skins/layer_cover.hpp"
#include "planning/skins/part_sides.hpp"

namespace lamina {

/// A part in which places are looked up. Queries may be made from several threads.
struct PartSpace {
  NearestTriangle surface;
  PartSides sides;

  /// @param mesh  closed; must outlive this
  /// @throws InvalidInput if it has no triangle
  explicit PartSpace(const Mesh& mesh) : surface(mesh), sides(mesh) {}
};

/// How far skins look from a layer that is planned on charts, and how closely.
struct SkinReach {
  std::size_t above = 0;  ///< layers that a skin seen from above counts
  std::size_t below = 0;  ///< the same from below
  double bead_mm = 0.4;   ///< width of beads; places are sampled at half this distance
  double wall_mm = 0.0;   ///< thickness of the walls; places within the walls are not looked up
};

/// The cover of a layer on charts, in the plane of the charts. A place is covered from above if the part is
/// still there at 1 to `reach.above` layer thicknesses farther along the growth (from the middle of the layer
/// to its nozzle tips); from below, at 1 to `reach.below` in the opposite direction. Borders are accurate to
/// half a bead.
/// @param material  the outlines of all charts, united
LayerCover coverOnCharts(const std::vector<LayerChart>& charts, Regions material, const PartSpace& part,
                         const SkinReach& reach);

}  // namespace lamina
