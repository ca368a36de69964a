// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/order/end_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace lamina {

EndGrid::EndGrid(const std::vector<RunEnds>& runs) : runs_(runs), is_taken_(runs.size(), false) {
  Box2 box;
  for (const RunEnds& run : runs) {
    box.include(run.first);
    box.include(run.last);
  }
  low_ = box.isEmpty() ? Point2(Point2::Zero()) : box.low;
  const Point2 size = box.size();
  const auto runs_wanted = static_cast<double>(std::max<std::size_t>(1, runs.size()));
  // Square cells, also where all ends lie on a line.
  cell_ = std::max({std::sqrt(size.x() * size.y() / runs_wanted), size.maxCoeff() / runs_wanted, 1e-6});
  columns_ = static_cast<std::int64_t>(size.x() / cell_) + 1;
  rows_ = static_cast<std::int64_t>(size.y() / cell_) + 1;
  const auto cellOf = [this](std::uint32_t end) {
    return static_cast<std::size_t>(row(pointOf(end).y()) * columns_ + column(pointOf(end).x()));
  };
  const auto end_count = static_cast<std::uint32_t>(2 * runs.size());
  count_.assign(static_cast<std::size_t>(columns_ * rows_), 0);
  for (std::uint32_t end = 0; end < end_count; ++end) ++count_[cellOf(end)];
  begin_.assign(count_.size(), 0);
  std::partial_sum(count_.begin(), count_.end() - 1, begin_.begin() + 1);
  std::vector<std::uint32_t> next = begin_;
  ends_.resize(end_count);
  for (std::uint32_t end = 0; end < end_count; ++end) ends_[next[cellOf(end)]++] = end;
}

const Point2& EndGrid::pointOf(std::uint32_t end) const {
  return end % 2 == 0 ? runs_[end / 2].first : runs_[end / 2].last;
}

std::int64_t EndGrid::column(double x) const {
  return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor((x - low_.x()) / cell_)), 0,
                                  columns_ - 1);
}

std::int64_t EndGrid::row(double y) const {
  return std::clamp<std::int64_t>(static_cast<std::int64_t>(std::floor((y - low_.y()) / cell_)), 0,
                                  rows_ - 1);
}

void EndGrid::searchCell(std::int64_t x, std::int64_t y, const Point2& point, Candidate& best) {
  const auto cell = static_cast<std::size_t>(y * columns_ + x);
  for (std::uint32_t i = begin_[cell]; i < begin_[cell] + count_[cell];) {
    const std::uint32_t end = ends_[i];
    if (is_taken_[end / 2]) {
      ends_[i] = ends_[begin_[cell] + --count_[cell]];
      continue;
    }
    const double distance = (pointOf(end) - point).squaredNorm();
    if (distance < best.squared_distance || (distance == best.squared_distance && end < best.end))
      best = {distance, end};
    ++i;
  }
}

void EndGrid::searchLoop(std::int64_t radius, const Point2& point, Candidate& best) {
  const std::int64_t x = column(point.x());
  const std::int64_t y = row(point.y());
  const std::int64_t left = std::max<std::int64_t>(0, x - radius);
  const std::int64_t right = std::min(columns_ - 1, x + radius);
  for (const std::int64_t outermost : {y - radius, y + radius}) {
    if (outermost < 0 || outermost >= rows_) continue;
    for (std::int64_t column = left; column <= right; ++column) searchCell(column, outermost, point, best);
  }
  const std::int64_t bottom = std::max<std::int64_t>(0, y - radius + 1);
  const std::int64_t top = std::min(rows_ - 1, y + radius - 1);
  for (const std::int64_t outermost : {x - radius, x + radius}) {
    if (outermost < 0 || outermost >= columns_) continue;
    for (std::int64_t row = bottom; row <= top; ++row) searchCell(outermost, row, point, best);
  }
}

OrderedRun EndGrid::takeNearest(const Point2& point) {
  Candidate best{std::numeric_limits<double>::infinity(), 0};
  const std::int64_t last_loop = std::max(columns_, rows_);
  for (std::int64_t radius = 0; radius <= last_loop; ++radius) {
    // Seen from a point in the middle cell, all of this loop is at least this far away; from one outside the
    // grid even farther.
    const double least = static_cast<double>(radius - 1) * cell_;
    if (radius > 0 && least > 0.0 && least * least > best.squared_distance) break;
    searchLoop(radius, point, best);
  }
  is_taken_[best.end / 2] = true;
  return {best.end / 2, best.end % 2 == 1};
}

}  // namespace lamina
