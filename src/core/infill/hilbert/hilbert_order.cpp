// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/hilbert/hilbert_order.hpp"

#include <algorithm>
#include <utility>

namespace lamina {
namespace {

/// Walks the quadrants of a Hilbert curve, passing over those outside the lattice.
class HilbertWalk {
 public:
  HilbertWalk(int columns, int rows) : columns_(columns), rows_(rows) {}

  /// @param corner  where the curve of this square starts
  /// @param along, across  steps from there over half the square: towards where the curve ends, and aside
  void walk(Cell corner, Cell along, Cell across, int half) {
    if (isOutside(corner, along, across, half)) return;
    if (half == 0) {
      order.push_back(corner);
      return;
    }
    const int next = half / 2;
    const auto step = [&corner](const Cell& a, int times_a, const Cell& b, int times_b) {
      return Cell{corner.column + a.column * times_a + b.column * times_b,
                  corner.row + a.row * times_a + b.row * times_b};
    };
    walk(corner, across, along, next);
    walk(step(across, half, along, 0), along, across, next);
    walk(step(across, half, along, half), along, across, next);
    const Cell back_along{-along.column, -along.row};
    const Cell back_across{-across.column, -across.row};
    walk(step(across, half - 1, along, 2 * half - 1), back_across, back_along, next);
  }

  std::vector<Cell> order;

 private:
  bool isOutside(const Cell& corner, const Cell& along, const Cell& across, int half) const {
    const int reach = half == 0 ? 0 : 2 * half - 1;
    const int end_column = corner.column + (along.column + across.column) * reach;
    const int end_row = corner.row + (along.row + across.row) * reach;
    return std::min(corner.column, end_column) >= columns_ || std::min(corner.row, end_row) >= rows_;
  }

  int columns_;
  int rows_;
};

}  // namespace

int hilbertLevel(int columns, int rows) {
  int level = 0;
  while ((std::int64_t{1} << level) < std::max(columns, rows)) ++level;
  return level;
}

std::vector<Cell> hilbertOrder(int columns, int rows) {
  if (columns <= 0 || rows <= 0) return {};
  HilbertWalk walk(columns, rows);
  const int level = hilbertLevel(columns, rows);
  walk.order.reserve(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  walk.walk({0, 0}, {1, 0}, {0, 1}, level == 0 ? 0 : 1 << (level - 1));
  return std::move(walk.order);
}

std::uint64_t hilbertPlace(const Cell& cell, int level) {
  auto x = static_cast<std::uint64_t>(cell.column);
  auto y = static_cast<std::uint64_t>(cell.row);
  std::uint64_t place = 0;
  const std::uint64_t side = std::uint64_t{1} << level;
  for (std::uint64_t s = side / 2; s > 0; s /= 2) {
    const std::uint64_t right = (x & s) != 0 ? 1 : 0;
    const std::uint64_t up = (y & s) != 0 ? 1 : 0;
    place += s * s * ((3 * right) ^ up);
    if (up != 0) continue;
    if (right != 0) {
      x = side - 1 - x;
      y = side - 1 - y;
    }
    std::swap(x, y);
  }
  return place;
}

}  // namespace lamina
