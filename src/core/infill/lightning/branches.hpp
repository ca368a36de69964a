// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// What a layer of branches is given.
struct BranchLayer {
  Regions inside;         ///< where branches may run: within the walls [mm]
  Regions roof;           ///< the part of it that solid material of the next layer lies on
  double reach_mm = 0.0;  ///< by which a bead of the next layer may stand out over one of this layer
};

/// How branches stand.
struct BranchSettings {
  double spacing_mm = 2.0;  ///< no place of a roof is farther than half of it from a branch or a wall
  double overrun_mm = 0.0;  ///< by which branches run into the walls they grow from
};

/// Branches that hold up roofs and nothing else. From the top layer down, tips under each roof are joined to
/// the nearest wall or branch, places near to those first; in each layer below, branches are shorter at their
/// tips by the reach, straightened by no more than that, and joined to the wall where that has moved away. So
/// every bead of a branch lies on one of the layer below, or stands out over it by the reach at most.
/// @param layers  from the bottom
/// @return as many as layers: the branches of each, from the tip to the wall or to another branch
std::vector<std::vector<Polyline>> branchesUnderRoofs(const std::vector<BranchLayer>& layers,
                                                      const BranchSettings& settings, Progress& progress);

}  // namespace lamina
