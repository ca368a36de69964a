// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

namespace lamina {

/// A cell of a square lattice.
struct Cell {
  int column = 0;
  int row = 0;

  friend bool operator==(const Cell& a, const Cell& b) { return a.column == b.column && a.row == b.row; }
};

/// Cells of `columns` x `rows` in the order in which a Hilbert curve that starts at (0, 0) visits them. The
/// curve covers the smallest square of 2^n x 2^n cells that contains the lattice. Cells outside the lattice
/// are left out, so that two successive cells need not be neighbours.
std::vector<Cell> hilbertOrder(int columns, int rows);

/// Index of a cell along the Hilbert curve over 2^level x 2^level cells.
std::uint64_t hilbertPlace(const Cell& cell, int level);

/// The lowest level whose curve covers that many columns and rows.
int hilbertLevel(int columns, int rows);

}  // namespace lamina
