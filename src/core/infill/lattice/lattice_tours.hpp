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

  /// For each cell its two neighbours along its tour; kNone twice for a cell in no tour.
  std::vector<std::array<std::uint32_t, 2>> neighbours;

  bool visits(std::uint32_t cell) const { return neighbours[cell][0] != kNone; }
};

/// Makes few tours over nearly all cells. First every 2 x 2 cells form a tour. Then tours side by side are
/// merged where two of their steps face each other, beginning with those closest along the Hilbert curve, so
/// that the result follows that curve wherever the region allows it. Remaining pairs of cells are added to a
/// tour beside them. Single cells at the border and places one cell wide remain outside all tours.
LatticeTours makeTours(const Lattice& lattice);

}  // namespace lamina
