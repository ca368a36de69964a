// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/geometry/spatial/point_grid.hpp"

#include <cmath>
#include <utility>

namespace lamina {
namespace {

constexpr double kMostCells = 4e6;

}  // namespace

PointGrid::PointGrid(const Box2& box, double cell_mm) : cell_mm_(cell_mm) {
  const Point2 size = box.size();
  cell_mm_ = std::max({cell_mm_, std::sqrt(size.x() * size.y() / kMostCells), size.maxCoeff() / kMostCells});
  if (!box.isEmpty()) low_ = box.low;
  columns_ = 1 + static_cast<int>(size.x() / cell_mm_);
  rows_ = 1 + static_cast<int>(size.y() / cell_mm_);
  first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), kNone);
}

int PointGrid::cellOf(double offset, int count) const {
  return static_cast<int>(std::clamp(offset / cell_mm_, 0.0, static_cast<double>(count - 1)));
}

std::size_t PointGrid::cell(const Point2& point) const { return cellAt(column(point.x()), row(point.y())); }

std::uint32_t PointGrid::insert(const Point2& point) {
  const auto index = static_cast<std::uint32_t>(points_.size());
  std::uint32_t& first = first_[cell(point)];
  points_.push_back(point);
  next_.push_back(first);
  first = index;
  ++count_;
  return index;
}

void PointGrid::remove(std::uint32_t index) {
  std::uint32_t* link = &first_[cell(points_[index])];
  while (*link != kNone && *link != index) link = &next_[*link];
  if (*link == kNone) return;
  *link = next_[index];
  --count_;
}

bool PointGrid::hasNearer(const Point2& place, double distance) const {
  return hasNear(place, distance,
                 [&](std::uint32_t, double squared) { return squared < distance * distance; });
}

void PointGrid::searchCell(int column, int row, const Point2& place, Candidate& best) const {
  for (std::uint32_t i = first_[cellAt(column, row)]; i != kNone; i = next_[i]) {
    const double squared = (points_[i] - place).squaredNorm();
    if (squared < best.squared || (squared == best.squared && i < best.index)) best = {squared, i};
  }
}

/// The cells round the place's own, so many away.
void PointGrid::searchLoop(int radius, const Point2& place, Candidate& best) const {
  const int x = column(place.x());
  const int y = row(place.y());
  const int left = std::max(0, x - radius);
  const int right = std::min(columns_ - 1, x + radius);
  for (const int outermost : {y - radius, y + radius}) {
    if (outermost < 0 || outermost >= rows_) continue;
    for (int column = left; column <= right; ++column) searchCell(column, outermost, place, best);
  }
  const int bottom = std::max(0, y - radius + 1);
  const int top = std::min(rows_ - 1, y + radius - 1);
  for (const int outermost : {x - radius, x + radius}) {
    if (outermost < 0 || outermost >= columns_) continue;
    for (int row = bottom; row <= top; ++row) searchCell(outermost, row, place, best);
  }
}

std::optional<std::uint32_t> PointGrid::nearest(const Point2& place) const {
  if (count_ == 0) return std::nullopt;
  Candidate best;
  const int last_loop = std::max(columns_, rows_);
  for (int radius = 0; radius <= last_loop; ++radius) {
    // Seen from the cell in the middle, all of this loop is at least this far away; from a place outside the
    // grid even farther, and so are points outside it.
    const double least = (radius - 1) * cell_mm_;
    if (least > 0.0 && least * least > best.squared) break;
    searchLoop(radius, place, best);
  }
  return best.index;
}

std::optional<std::uint32_t> PointGrid::nearest(const Point2& place, double tie_mm) const {
  if (count_ == 0) return std::nullopt;
  const double least = (points_[*nearest(place)] - place).squaredNorm();
  std::optional<std::uint32_t> first;
  visitNear(place, std::nextafter(std::sqrt(least), 2.0 * least + 1.0) + tie_mm,
            [&](std::uint32_t i, double) {
              if (!first || std::make_pair(points_[i].x(), points_[i].y()) <
                                std::make_pair(points_[*first].x(), points_[*first].y()))
                first = i;
            });
  return first;
}

}  // namespace lamina
