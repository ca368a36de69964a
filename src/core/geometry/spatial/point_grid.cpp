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

std::size_t PointGrid::cell(const Point2& point) const {
  return static_cast<std::size_t>(row(point.y())) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(column(point.x()));
}

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
  bool is_found = false;
  visitNear(place, distance,
            [&](std::uint32_t, double squared) { is_found |= squared < distance * distance; });
  return is_found;
}

std::optional<std::uint32_t> PointGrid::nearest(const Point2& place, double tie_mm) const {
  if (count_ == 0) return std::nullopt;
  double least = std::numeric_limits<double>::infinity();
  for (double radius = cell_mm_; std::isinf(least); radius *= 2.0)
    visitNear(place, radius, [&](std::uint32_t, double squared) { least = std::min(least, squared); });
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
