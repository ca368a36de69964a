// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "infill/lattice/lattice.hpp"

namespace lamina {

/// Closed tours over the cells of a lattice, from neighbour to neighbour, that visit no cell twice.
struct LatticeTours {
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  /// Of each cell the two neighbours along its tour; kNone twice for a cell that no tour visits.
  std::vector<std::array<std::uint32_t, 2>> neighbours;

  bool visits(std::uint32_t cell) const { return neighbours[cell][0] != kNone; }
};

/// Few tours over nearly all cells: 2 x 2 cells make a tour each; tours side by side become one where two of
/// their steps face each other, those first that lie close to each other along the Hilbert curve, so that the
/// whole follows that curve wherever the region allows it. Pairs of cells left over are taken in by a tour
/// beside them. What remains are single cells at the border and places one cell wide.
LatticeTours makeTours(const Lattice& lattice);

}  // namespace lamina
