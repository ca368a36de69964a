// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "planning/layer_planner.hpp"

namespace lamina {

/// A piece of an island and what it is planned by.
struct IslandPiece {
  const LayerVariant* plan = nullptr;
  Regions area;  ///< those of an island's pieces do not overlap, and together cover it
};

/// Shares out an island among the variants of a layer and the plan itself, in this order; pieces below
/// 1e-3 mm² go to what is beside them.
/// @param plan  its area is what no variant takes
/// @return one at least, which refer to the arguments
std::vector<IslandPiece> piecesOf(const Region& island, const LayerVariant& plan,
                                  const std::vector<LayerVariant>& variants);

/// Fewest walls of any piece.
int leastWalls(const std::vector<IslandPiece>& pieces);

/// What walls were laid by.
struct WallRules {
  const PlanSettings* plan = nullptr;
  std::size_t layer = 0;
};

/// Gives walls of an island that were laid by feeds, flow and tool of the plan those of the pieces they run
/// through: waypoints are added where a wall crosses from one piece into another, and it is cut where the
/// tool changes. Where a wall was slower, as over nothing, it stays so in the same measure.
/// @param from  paths before that one stay as they are, as do travels
std::vector<Path> laidByPieces(std::vector<Path> paths, std::size_t from,
                               const std::vector<IslandPiece>& pieces, const WallRules& laid_by);

}  // namespace lamina
