// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// The solid angle that a mesh covers as seen from a point: 4 pi inside a closed mesh that faces outwards, 0
/// outside, and nearly so if some triangles are missing. Groups of triangles that are far from the point
/// compared with their extent count as one small area, after [Barill2018]. If the result is so near 2 pi that
/// this approximation could decide the side, every triangle counts by itself. The side of a point is thus
/// found in a time that hardly grows with the number of triangles. Queries may be made from several threads.
class SolidAngle {
 public:
  /// @param mesh  must outlive this
  explicit SolidAngle(const Mesh& mesh);

  /// Whether the point is inside: the mesh covers more than half of all directions, whichever way its
  /// triangles face. No point is inside an empty mesh.
  bool isWithin(const Point3& point) const;

  /// The solid angle summed triangle by triangle, without approximation [sr].
  double exactAt(const Point3& point) const;

 private:
  struct Node {
    Point3 middle = Point3::Zero();  ///< of the areas
    Point3 area = Point3::Zero();    ///< along the normals, summed [mm²]
    double radius_mm = 0.0;          ///< of all corners about the middle
    std::uint32_t first = 0;  ///< index of the first triangle of a leaf, otherwise number of the right child
    std::uint32_t count = 0;  ///< 0 for an inner node, whose left child follows it
  };

  std::uint32_t build(std::uint32_t first, std::uint32_t last, const std::vector<Point3>& middles);
  Node nodeOf(std::uint32_t first, std::uint32_t last) const;
  double roughAt(std::uint32_t number, const Point3& point) const;
  double ofTriangle(std::uint32_t triangle, const Point3& point) const;

  const Mesh& mesh_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

}  // namespace lamina
