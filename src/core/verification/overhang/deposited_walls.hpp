// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Properties of the wall that carries a facet: growth direction of its layer, and height and width of its
/// bead.
struct LayerGrowth {
  Point3 direction;
  Bead bead;
};

/// The motions along which walls are deposited, in order, and the growth of each.
struct DepositedWalls {
  Mesh motions;  ///< each motion as a triangle without width
  std::vector<LayerGrowth> growth;
  std::size_t in_first_layer = 0;
};

/// The motions of outer walls, or of all walls and infill if there are no outer walls.
/// @throws InvalidInput if nothing is deposited
DepositedWalls depositedWalls(const Toolpath& toolpath, double width_mm);

}  // namespace lamina
