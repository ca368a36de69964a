// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "infill/contour/contour_tree.hpp"
#include "infill/contour/loop_graph.hpp"
#include "lamina/infill/strategy.hpp"

namespace lamina {

/// The loops of a tree as a graph, nothing cut yet; the indices are those of `ContourTree::loops`.
LoopGraph loopsOf(const ContourTree& tree);

/// Joins all loops that do not hang together yet: neighbours are cut open by a gap nearly as wide as they are
/// apart, and joined by two links across. Loops that have no neighbour near enough stay separate.
/// @param region  its index among those that are filled, for the seed
void joinLoops(LoopGraph& net, const ContourTree& tree, const InfillRequest& request, std::size_t region);

}  // namespace lamina
