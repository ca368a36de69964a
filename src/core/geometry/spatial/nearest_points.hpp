// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// A point found near a place.
struct NearPoint {
  double squared = 0.0;     ///< distance from the place, squared [mm²]
  std::uint32_t index = 0;  ///< of the point
};

/// Finds the points in space that are nearest to a place, in logarithmic time. Queries may be made from
/// several threads.
class NearestPoints {
 public:
  explicit NearestPoints(std::vector<Point3> points);

  const std::vector<Point3>& points() const { return points_; }

  /// The nearest points, nearest first, equally near ones in the order of their indices.
  /// @param count  how many; all points are found if there are fewer
  std::vector<NearPoint> nearest(const Point3& place, std::size_t count) const;

 private:
  struct Search;

  void build(std::size_t first, std::size_t last);
  void visit(std::size_t first, std::size_t last, Search& search) const;

  std::vector<Point3> points_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint8_t> axis_;  // across which the point at this place of the order divides its range
};

}  // namespace lamina
