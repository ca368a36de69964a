// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// One closed curve for each region that follows a Hilbert curve wherever the region allows it: a Hamiltonian
/// tour (`makeTours`) over the cells of a lattice fitted to the region's bounding box. Necks one cell wide,
/// and single cells at the border, are traversed in both directions, each time with half the bead. If the
/// lattice of a region is not connected, each connected part is a run.
///
/// If `hilbert.angles` is above 1, that many angles within a right angle are tried, for the fewest runs and,
/// among those, the most cells.
std::vector<FillPath> hilbertQuadtree(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
