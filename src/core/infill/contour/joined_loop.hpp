// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "infill/contour/contour_tree.hpp"
#include "infill/contour/loop_graph.hpp"
#include "lamina/infill/strategy.hpp"

namespace lamina {

/// The loops of a tree as a graph without cuts; indices are those of `ContourTree::loops`.
LoopGraph loopsOf(const ContourTree& tree);

/// Joins all loops that are not connected yet: neighbours are cut open by a gap nearly as wide as their
/// distance, and joined by two links across it. Loops without a neighbour near enough stay separate.
/// @param region  index of the region among those that are filled, for the seed
void joinLoops(LoopGraph& net, const ContourTree& tree, const InfillRequest& request, std::size_t region);

}  // namespace lamina
