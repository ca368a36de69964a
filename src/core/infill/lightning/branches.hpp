// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// A layer as input for the branches in it.
struct BranchLayer {
  Regions inside;         ///< area within the walls, where branches may be [mm]
  Regions roof;           ///< part of `inside` below solid material of the next layer
  double reach_mm = 0.0;  ///< distance by which a bead of the next layer may overhang a bead of this layer
};

/// Density and overlap of branches.
struct BranchSettings {
  double spacing_mm = 2.0;  ///< no point of a roof is farther than half of this from a branch or a wall
  double overrun_mm = 0.0;  ///< by which branches extend into the walls from which they grow
};

/// Branches that support roofs and nothing else, made from the top layer down. Tips under each roof are
/// joined to the nearest wall or branch, the nearest ones first. In each layer below, branches are shortened
/// at their tips by the reach, straightened by at most the reach, and extended to the wall where it has moved
/// away. Every bead of a branch thus lies on a bead of the layer below, or overhangs it by at most the reach.
/// @param layers  from the bottom
/// @return the branches of each layer, each from its tip to the wall or another branch
std::vector<std::vector<Polyline>> branchesUnderRoofs(const std::vector<BranchLayer>& layers,
                                                      const BranchSettings& settings, Progress& progress);

}  // namespace lamina
