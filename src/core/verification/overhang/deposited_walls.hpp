// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// What carries a facet: the way its layer grows, and how high and wide its bead is.
struct LayerGrowth {
  Point3 direction;
  Bead bead;
};

/// The motions along which walls are deposited, in the order they are deposited, and how they grow.
struct DepositedWalls {
  Mesh motions;  ///< each one a triangle without width
  std::vector<LayerGrowth> growth;
  std::size_t in_first_layer = 0;
};

/// The outer walls, or all walls and infill if there are none.
/// @throws InvalidInput if nothing is deposited
DepositedWalls depositedWalls(const Toolpath& toolpath, double width_mm);

}  // namespace lamina
