// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "infill/lattice/lattice.hpp"
#include "infill/lattice/lattice_tours.hpp"

namespace lamina {

/// A walk from cell to neighbouring cell.
struct LatticeWalk {
  std::vector<std::uint32_t> cells;
  std::vector<bool> is_doubled;  ///< for each cell whether the step to it is walked in both directions
  bool is_closed = false;
};

/// One walk over all cells of each connected part of the lattice, diagonals included if they were found.
/// Tours and cells outside tours are connected by steps that are walked in both directions. Parts that are a
/// row of single cells are walked once, from end to end. A part of a single cell has no walk.
std::vector<LatticeWalk> walkLattice(const Lattice& lattice, const LatticeTours& tours);

}  // namespace lamina
