// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/vector.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/order/starts_in_air.hpp"

namespace lamina {

/// Islands of inclined layers that begin in mid-air: nothing of them comes within the width of a bead of the
/// bed, the layer before or a support.
struct FloatingIslands {
  std::size_t count = 0;
  std::size_t first_layer = 0;       ///< layer of the first island
  Point3 first_mm = Point3::Zero();  ///< start of a run of the first island, in the frame of the layers
};

/// Inclined layers and their plan.
struct PlannedStack {
  const CarriedLayers& carried;
  const std::vector<ToolpathLayer>& toolpath;  ///< the plan of the layers, in their frame
  const StartsInAir& starts;                   ///< of it
};

/// Level layers have none: their islands are left to supports. An island without beads neither floats nor
/// carries.
FloatingIslands floatingIslands(const PlannedStack& stack);

/// @throws InvalidInput if the first layer of the part, or an island of a later one, begins in mid-air
void requireStanding(const PlannedStack& stack, const Eigen::Isometry3d& part_from_layers);

}  // namespace lamina
