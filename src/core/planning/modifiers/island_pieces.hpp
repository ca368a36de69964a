// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/layer_planner.hpp"

namespace lamina {

/// A piece of an island and what it is planned by.
struct IslandPiece {
  const PlanContext* context = nullptr;
  const LayerCover* cover = nullptr;
  Regions area;  ///< those of an island's pieces do not overlap, and together cover it
};

/// Shares out an island among the variants of a layer and the plan itself, in this order; pieces below
/// 1e-3 mm² go to what is beside them.
std::vector<IslandPiece> piecesOf(const Region& island, const LayerVariant& plan,
                                  const std::vector<LayerVariant>& variants);

/// Fewest walls of any piece.
int leastWalls(const std::vector<IslandPiece>& pieces);

/// Gives the walls of an island that were laid with the feeds of the plan those of the pieces they run
/// through: waypoints are added where a wall crosses from one piece into another of another feed.
Path withFeedsOf(Path wall, const std::vector<IslandPiece>& pieces, std::size_t layer);

}  // namespace lamina
