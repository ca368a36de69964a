// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/spatial/box_tree.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/geometry/spatial/solid_angle.hpp"

namespace lamina {

/// The inside and outside of a part. Queries may be made from several threads.
class PartSides {
 public:
  /// @param mesh  closed; must outlive this
  explicit PartSides(const Mesh& mesh);

  /// Whether a place is inside, by `SolidAngle`.
  bool isWithin(const Point3& place) const { return inside_.isWithin(place); }

  /// Whether the straight line between two places certainly meets no triangle, so that both are on the same
  /// side. Far cheaper than a solid angle if the places are near each other.
  bool isClearBetween(const Point3& from, const Point3& to) const;

 private:
  bool mayMeet(std::size_t triangle, const Point3& from, const Point3& to) const;

  const Mesh& mesh_;
  SolidAngle inside_;
  BoxTree boxes_;  ///< of the triangles
};

/// The sides of places in rows. Most follow from the side of the place before in the row, which is near.
class RowSides {
 public:
  /// @param part     must outlive this
  /// @param near_mm  greatest distance at which the side of a place is derived from the place before
  RowSides(const PartSides& part, std::size_t rows, double near_mm)
      : part_(part), near_mm_(near_mm), last_(rows) {}

  /// Whether the next place of a row is inside, as by `PartSides::isWithin`.
  bool isWithin(const Point3& place, std::size_t row);

  /// Number of places whose side was computed by a solid angle.
  std::size_t solidAngles() const { return solid_angles_; }

 private:
  struct Known {
    Point3 place = Point3::Zero();
    bool is_within = false;
  };

  const PartSides& part_;
  double near_mm_;
  std::vector<std::optional<Known>> last_;  ///< place of each row
  std::size_t solid_angles_ = 0;
};

}  // namespace lamina
