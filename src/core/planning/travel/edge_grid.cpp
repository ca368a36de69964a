// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/travel/edge_grid.hpp"

#include <numeric>

namespace lamina {
namespace {

constexpr double kLeastCell = 1e-3;      // mm
constexpr double kMostAcross = 1 << 12;  // cells, of an area however thin

}  // namespace

EdgeGrid::EdgeGrid(const std::vector<std::pair<Point2, Point2>>& edges) {
  if (edges.empty()) return;
  Box2 box;
  for (const auto& [from, to] : edges) {
    box.include(from);
    box.include(to);
  }
  const Point2 size = box.size();
  const double mean = std::sqrt(size.x() * size.y() / static_cast<double>(edges.size()));
  cell_mm_ = std::max({mean, size.maxCoeff() / kMostAcross, kLeastCell});
  low_ = box.low;
  columns_ = 1 + static_cast<std::size_t>(size.x() / cell_mm_);
  rows_ = 1 + static_cast<std::size_t>(size.y() / cell_mm_);
  first_.assign(columns_ * rows_ + 1, 0);
  const auto forCellsOf = [&](std::size_t edge, const auto& act) {
    forCellsAlong(edges[edge].first, edges[edge].second, [&](std::size_t column, std::size_t row) {
      act(row * columns_ + column);
      return true;
    });
  };
  for (std::size_t i = 0; i < edges.size(); ++i) forCellsOf(i, [&](std::size_t cell) { ++first_[cell + 1]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  edges_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < edges.size(); ++i)
    forCellsOf(i, [&](std::size_t cell) { edges_[next[cell]++] = i; });
}

}  // namespace lamina
