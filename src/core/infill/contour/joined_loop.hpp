// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "infill/contour/contour_tree.hpp"
#include "infill/contour/loop_graph.hpp"
#include "lamina/infill/strategy.hpp"

namespace lamina {

/// The loops of a tree as rings, nothing cut yet; ring i is loop i.
RingNet ringsOf(const ContourTree& tree);

/// Joins all rings that do not hang together yet: neighbours are cut open by a gap nearly as wide as they are
/// apart, and joined by two links across. Rings that have no neighbour near enough stay by themselves.
/// @param region  its index among those that are filled, for the seed
void joinRings(RingNet& net, const ContourTree& tree, const InfillRequest& request, std::size_t region);

}  // namespace lamina
