// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/overhangs/border_distance.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/polygon/plane_vectors.hpp"

namespace lamina {
namespace {

constexpr double kFewestCells = 32.0;       // across
constexpr double kMostCells = 1024.0;       // across
constexpr double kCellSlack = 1e-6;         // cells, far above rounding
constexpr double kAsideOfCorners = 0.0137;  // cells: middles of cells lie on no corner of usual parts

}  // namespace

int BorderDistance::clamped(double position, int count) {
  return static_cast<int>(std::clamp(std::floor(position), 0.0, static_cast<double>(count - 1)));
}

BorderDistance::BorderDistance(const Regions& regions, double reach_mm) : reach_(reach_mm) {
  const std::vector<Polygon> borders = outlines(regions);
  for (const Polygon& border : borders)
    for (std::size_t i = 0, j = border.size() - 1; i < border.size(); j = i++)
      edges_.emplace_back(border[j], border[i]);
  const Box2 box = boundingBox(borders);
  if (box.isEmpty()) return;
  const double across = std::clamp(2.0 * std::sqrt(double(edges_.size())), kFewestCells, kMostCells);
  cell_mm_ = std::max(reach_, box.size().maxCoeff() / across);
  low_ = box.low.array() - reach_ - kAsideOfCorners * cell_mm_;
  columns_ = 1 + static_cast<int>((box.high.x() + reach_ - low_.x()) / cell_mm_);
  rows_ = 1 + static_cast<int>((box.high.y() + reach_ - low_.y()) / cell_mm_);
  sortEdges();
  findInside();
}

template <class Visit>
void BorderDistance::forCells(const Edge& edge, const Visit& visit) const {
  const Point2 a = (edge.first - low_) / cell_mm_;
  const Point2 along = (edge.second - edge.first) / cell_mm_;
  const int last_row = clamped(std::max(a.y(), a.y() + along.y()) + kCellSlack, rows_);
  for (int row = clamped(std::min(a.y(), a.y() + along.y()) - kCellSlack, rows_); row <= last_row; ++row) {
    double start = 0.0, end = 1.0;  // the part of the edge in this row
    if (std::abs(along.y()) > kCellSlack) {
      const double one = (row - kCellSlack - a.y()) / along.y();
      const double other = (row + 1 + kCellSlack - a.y()) / along.y();
      start = std::clamp(std::min(one, other), 0.0, 1.0);
      end = std::clamp(std::max(one, other), 0.0, 1.0);
    }
    const double x = a.x() + start * along.x();
    const double y = a.x() + end * along.x();
    const int last = clamped(std::max(x, y) + kCellSlack, columns_);
    for (int column = clamped(std::min(x, y) - kCellSlack, columns_); column <= last; ++column)
      visit(cellAt(column, row));
  }
}

void BorderDistance::sortEdges() {
  begin_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const Edge& edge : edges_) forCells(edge, [&](std::size_t cell) { ++begin_[cell + 1]; });
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  held_.resize(begin_.back());
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  for (std::uint32_t e = 0; e < edges_.size(); ++e)
    forCells(edges_[e], [&](std::size_t cell) { held_[next[cell]++] = e; });
}

/// Row by row, from crossing to crossing of the line through the middles.
void BorderDistance::findInside() {
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(rows_));
  for (const auto& [a, b] : edges_) {
    const auto [low, high] = std::minmax(a.y(), b.y());
    for (int row = rowOf(low); row <= rowOf(high); ++row) {
      const double y = centreOf(0, row).y();
      if ((a.y() > y) == (b.y() > y)) continue;
      crossings[static_cast<std::size_t>(row)].push_back(a.x() +
                                                         (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
    }
  }
  is_inside_.assign(begin_.size() - 1, false);
  for (int row = 0; row < rows_; ++row) {
    std::vector<double>& line = crossings[static_cast<std::size_t>(row)];
    std::sort(line.begin(), line.end());
    std::size_t passed = 0;
    for (int column = 0; column < columns_; ++column) {
      const double x = centreOf(column, row).x();
      while (passed < line.size() && line[passed] < x) ++passed;
      is_inside_[cellAt(column, row)] = passed % 2 == 1;
    }
  }
}

bool BorderDistance::isInside(const Point2& point) const {
  if (edges_.empty()) return false;
  const Point2 at = (point - low_) / cell_mm_;
  if (!(at.x() >= 0.0 && at.y() >= 0.0 && at.x() < columns_ && at.y() < rows_)) return false;
  const int column = columnOf(point.x());
  const int row = rowOf(point.y());
  const std::size_t cell = cellAt(column, row);
  bool is_inside = is_inside_[cell];
  const Point2 middle = centreOf(column, row);
  for (std::uint32_t i = begin_[cell]; i < begin_[cell + 1]; ++i)
    if (areCrossing(point, middle, edges_[held_[i]].first, edges_[held_[i]].second)) is_inside = !is_inside;
  return is_inside;
}

double BorderDistance::at(const Point2& point) const {
  if (edges_.empty()) return reach_;
  double nearest = reach_ * reach_;
  const Point2 reach(reach_, reach_);
  visitEdges(point - reach, point + reach, [&](const Point2& a, const Point2& b) {
    nearest = std::min(nearest, (nearestOnSegment(a, b, point) - point).squaredNorm());
  });
  return isInside(point) ? -std::sqrt(nearest) : std::sqrt(nearest);
}

}  // namespace lamina
