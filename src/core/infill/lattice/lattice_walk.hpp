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
  std::vector<bool> is_doubled;  ///< of each cell: the step to it is walked twice, there and back
  bool is_closed = false;
};

/// One walk over each connected part of the lattice, diagonals counted if they were found, over all of its
/// cells. Tours and the cells that no tour visits hang together by steps that are walked there and back.
/// Parts that are a row of single cells are walked once, from end to end. Parts of a single cell give none.
std::vector<LatticeWalk> walkLattice(const Lattice& lattice, const LatticeTours& tours);

}  // namespace lamina
