// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/spatial/edge_grid.hpp"

#include <numeric>

namespace lamina {
namespace {

constexpr double kLeastCell = 1e-3;      // mm
constexpr double kMostAcross = 1 << 12;  // cells, of an area however thin

}  // namespace

EdgeGrid::EdgeGrid(const std::vector<std::pair<Point2, Point2>>& edges, double fewest_across) {
  if (edges.empty()) return;
  Box2 box;
  for (const auto& [from, to] : edges) {
    box.include(from);
    box.include(to);
  }
  const Point2 size = box.size();
  const double mean = std::sqrt(size.x() * size.y() / static_cast<double>(edges.size()));
  const double coarsest = fewest_across > 0.0 ? size.maxCoeff() / fewest_across : mean;
  cell_mm_ = std::max({std::min(mean, coarsest), size.maxCoeff() / kMostAcross, kLeastCell});
  low_ = box.low;
  columns_ = 1 + static_cast<std::size_t>(size.x() / cell_mm_);
  rows_ = 1 + static_cast<std::size_t>(size.y() / cell_mm_);
  sort(edges);
}

EdgeGrid::EdgeGrid(const std::vector<std::pair<Point2, Point2>>& edges, const Box2& box, double cell_mm)
    : low_(box.low),
      cell_mm_(cell_mm),
      columns_(1 + static_cast<std::size_t>(box.size().x() / cell_mm)),
      rows_(1 + static_cast<std::size_t>(box.size().y() / cell_mm)) {
  sort(edges);
}

void EdgeGrid::sort(const std::vector<std::pair<Point2, Point2>>& edges) {
  first_.assign(columns_ * rows_ + 1, 0);
  const auto forCellsOf = [&](std::uint32_t edge, const auto& act) {
    forCellsAlong(edges[edge].first, edges[edge].second, [&](std::size_t column, std::size_t row) {
      act(row * columns_ + column);
      return true;
    });
  };
  for (std::uint32_t i = 0; i < edges.size(); ++i)
    forCellsOf(i, [&](std::size_t cell) { ++first_[cell + 1]; });
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  edges_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t i = 0; i < edges.size(); ++i)
    forCellsOf(i, [&](std::size_t cell) { edges_[next[cell]++] = i; });
}

std::optional<std::size_t> EdgeGrid::clearCell(const Point2& point) const {
  const Point2 at = (point - low_) / cell_mm_;
  if (isEmpty() || !(at.x() >= 0.0 && at.y() >= 0.0 && at.x() < static_cast<double>(columns_) &&
                     at.y() < static_cast<double>(rows_)))
    return std::nullopt;
  const std::size_t cell = static_cast<std::size_t>(at.y()) * columns_ + static_cast<std::size_t>(at.x());
  if (first_[cell] < first_[cell + 1]) return std::nullopt;
  return cell;
}

bool EdgeGrid::isClearAround(std::size_t cell) const {
  const std::size_t row = cell / columns_;
  const std::size_t column = cell % columns_;
  for (std::size_t r = row > 0 ? row - 1 : 0; r <= std::min(row + 1, rows_ - 1); ++r) {
    const std::size_t first = r * columns_ + (column > 0 ? column - 1 : 0);
    const std::size_t last = r * columns_ + std::min(column + 1, columns_ - 1);
    if (first_[first] < first_[last + 1]) return false;
  }
  return true;
}

bool EdgeGrid::areNeighbours(std::size_t cell, std::size_t next) const {
  const std::size_t row = cell / columns_;
  const std::size_t next_row = next / columns_;
  const std::size_t column = cell % columns_;
  const std::size_t next_column = next % columns_;
  return next_row + 1 >= row && row + 1 >= next_row && next_column + 1 >= column && column + 1 >= next_column;
}

}  // namespace lamina
