// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "infill/pattern/edge_cells.hpp"

#include <numeric>

namespace lamina {
namespace {

constexpr double kFewestCellsAcross = 32.0;
constexpr double kMostCellsAcross = 4096.0;

template <class Visit>
void forEdges(const std::vector<Polygon>& outlines, const Visit& visit) {
  for (std::uint32_t o = 0; o < outlines.size(); ++o)
    for (std::uint32_t i = 0; i < outlines[o].size(); ++i)
      visit(OutlineEdge{o, i}, outlines[o][i], outlines[o][i + 1 < outlines[o].size() ? i + 1 : 0]);
}

}  // namespace

EdgeCells::EdgeCells(const std::vector<Polygon>& outlines) {
  const Box2 box = boundingBox(outlines);
  std::size_t count = 0;
  for (const Polygon& outline : outlines) count += outline.size();
  const Point2 size = box.isEmpty() ? Point2(Point2::Zero()) : Point2(box.size());
  if (!box.isEmpty()) origin_ = box.low;
  const double across = std::sqrt(static_cast<double>(std::max<std::size_t>(count, 1)));
  cell_mm_ = std::max({size.maxCoeff() / std::clamp(across, kFewestCellsAcross, kMostCellsAcross), 1e-6});
  columns_ = 1 + static_cast<int>(size.x() / cell_mm_);
  rows_ = 1 + static_cast<int>(size.y() / cell_mm_);
  begin_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  forEdges(outlines, [&](const OutlineEdge&, const Point2& from, const Point2& to) {
    forCells(from, to, [&](std::size_t cell) { ++begin_[cell + 1]; });
  });
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  edges_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  forEdges(outlines, [&](const OutlineEdge& edge, const Point2& from, const Point2& to) {
    forCells(from, to, [&](std::size_t cell) { edges_[next[cell]++] = edge; });
  });
  is_clear_around_ = clearAround();
}

std::vector<bool> EdgeCells::clearAround() const {
  std::vector<bool> is_clear(begin_.size() - 1, true);
  for (int row = 0; row < rows_; ++row)
    for (int column = 0; column < columns_; ++column) {
      const auto cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                        static_cast<std::size_t>(column);
      if (begin_[cell] == begin_[cell + 1]) continue;
      for (int r = std::max(row - 1, 0); r <= std::min(row + 1, rows_ - 1); ++r)
        for (int c = std::max(column - 1, 0); c <= std::min(column + 1, columns_ - 1); ++c)
          is_clear[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
                   static_cast<std::size_t>(c)] = false;
    }
  return is_clear;
}

}  // namespace lamina
