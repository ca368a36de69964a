// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "planning/layer_planner.hpp"

namespace lamina {

/// A piece of an island and the plan that holds in it.
struct IslandPiece {
  const LayerVariant* plan = nullptr;
  Regions area;  ///< areas of an island's pieces do not overlap, and together cover the island
};

/// Divides an island among the variants of a layer and the plan itself, in this order. A piece below 1e-3 mm²
/// is added to a neighbouring piece.
/// @param plan  takes the area outside all variants
/// @return at least one piece; they refer to the arguments
std::vector<IslandPiece> piecesOf(const Region& island, const LayerVariant& plan,
                                  const std::vector<LayerVariant>& variants);

/// Least number of walls of any piece.
int leastWalls(const std::vector<IslandPiece>& pieces);

/// The settings and layer by which walls were deposited.
struct WallRules {
  const PlanSettings* plan = nullptr;
  std::size_t layer = 0;
};

/// Gives the walls of an island the feeds, flow and tool of the pieces through which they run, instead of
/// those of the plan. A wall gets a waypoint where it crosses into another piece, and is cut where the tool
/// changes. A factor already applied to the feed, as over an overhang, is kept.
/// @param from  index of the first path that is changed; travels are unchanged
std::vector<Path> depositedByPieces(std::vector<Path> paths, std::size_t from,
                                    const std::vector<IslandPiece>& pieces, const WallRules& deposited_by);

}  // namespace lamina
