// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/slicing/volumetric/direction_samples.hpp"
#include "slicing/volumetric/cell_graph.hpp"

namespace lamina {

/// Directions of unit length at the nodes of a part, from samples anywhere: at a sample the direction of the
/// sample, elsewhere the mean of the eight nearest ones, weighted by (1 / d - 1 / e)², where d is the
/// distance and e that of the ninth. A single sample holds for the whole part.
/// @param samples  [frame of the cells]
/// @throws InvalidInput if there is no sample, or naming place and distance if a node is farther from every
///   sample than both two cells and three times the median distance between neighbouring samples, or if the
///   directions about a node cancel each other out; Cancelled
std::vector<Point3> directionsAtNodes(const CellGraph& cells, const std::vector<DirectionSample>& samples,
                                      Progress& progress);

}  // namespace lamina
