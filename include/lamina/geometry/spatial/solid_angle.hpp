// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// The solid angle under which a point sees a mesh: 4 pi within a closed one that faces outwards, 0 outside,
/// and near to that if some triangles are missing. Triangles that are far from a point for their spread count
/// as one small area, after [Barill2018]; close to 2 pi, where that might decide otherwise, each counts by
/// itself. So which side a point is on is found in a time that hardly grows with the triangles. Queries may
/// be made from several threads.
class SolidAngle {
 public:
  /// @param mesh  must outlive this
  explicit SolidAngle(const Mesh& mesh);

  /// Whether the point sees more than half of all directions covered, whichever way the triangles face. Of an
  /// empty mesh nothing is within.
  bool isWithin(const Point3& point) const;

  /// Triangle by triangle [sr].
  double exactAt(const Point3& point) const;

 private:
  struct Node {
    Point3 middle = Point3::Zero();  ///< of the areas
    Point3 area = Point3::Zero();    ///< along the normals, summed [mm²]
    double radius_mm = 0.0;          ///< of all corners about the middle
    std::uint32_t first = 0;  ///< of its triangles if it is a leaf, otherwise the number of its right child
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
