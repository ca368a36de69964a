// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// The point with the most others within a distance of it.
/// @param points  one or more
Point3 densestPlace(const std::vector<Point3>& points, double within_mm);

/// Points spread evenly through the inside of a closed mesh: one at a random position in every cell of a
/// cubic grid, the same ones for the same mesh. Points are stored in columns: those of a column share x and
/// y, and ascend in z.
class PartSamples {
 public:
  /// @param mesh   closed, facing outwards; holds a positive volume
  /// @param count  approximate number of points
  PartSamples(const Mesh& mesh, std::size_t count);

  const std::vector<Point3>& points() const { return points_; }
  double spacing() const { return spacing_; }

  /// Calls visit(index of the point) for all points in a box.
  template <class Visit>
  void visitIn(const Box3& box, Visit visit) const;

 private:
  struct Column {
    Point2 place = Point2::Zero();
    std::uint32_t first = 0;
    std::uint32_t last = 0;
  };

  std::size_t cellOf(double offset, std::size_t count) const;
  std::vector<std::vector<std::pair<double, int>>> crossings(const Mesh& mesh) const;
  void fill(Column& column, std::vector<std::pair<double, int>> crossings, double low_z);

  double spacing_ = 0.0;
  Point2 low_ = Point2::Zero();
  std::size_t columns_x_ = 0;
  std::size_t columns_y_ = 0;
  std::vector<Column> columns_;
  std::vector<Point3> points_;
};

template <class Visit>
void PartSamples::visitIn(const Box3& box, Visit visit) const {
  const std::size_t last_x = cellOf(box.high.x() - low_.x(), columns_x_);
  const std::size_t last_y = cellOf(box.high.y() - low_.y(), columns_y_);
  for (std::size_t y = cellOf(box.low.y() - low_.y(), columns_y_); y <= last_y; ++y)
    for (std::size_t x = cellOf(box.low.x() - low_.x(), columns_x_); x <= last_x; ++x) {
      const Column& column = columns_[y * columns_x_ + x];
      const Point2& place = column.place;
      if (place.x() < box.low.x() || place.x() > box.high.x() || place.y() < box.low.y() ||
          place.y() > box.high.y())
        continue;
      for (std::uint32_t i = column.first; i < column.last; ++i)
        if (points_[i].z() >= box.low.z() && points_[i].z() <= box.high.z()) visit(i);
    }
}

}  // namespace lamina
