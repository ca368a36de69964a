// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/infill/strategy.hpp"

namespace lamina {

/// One closed curve per region that follows a Hilbert curve wherever the region allows it: the cells of a
/// lattice fitted to each region's box, joined by a Hamiltonian tour (`makeTours`). Necks one cell wide, and
/// single cells at the border, are run there and back, each time with half the bead. A region whose lattice
/// falls apart gives one run per part.
///
/// With `hilbert.angles` above 1 the curve is turned by that many angles within a right angle, for the fewest
/// runs and, among those, the most cells.
std::vector<FillPath> hilbertQuadtree(const Regions& regions, const InfillRequest& request);

}  // namespace lamina
