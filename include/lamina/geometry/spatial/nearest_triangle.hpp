// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// The point of a mesh that is nearest to a given point.
struct NearestPlace {
  std::uint32_t triangle = 0;     ///< index of the triangle on which the point lies
  Point3 point = Point3::Zero();  ///< [mm]
  double distance_mm = 0.0;
};

/// Finds the nearest point of a mesh in logarithmic time. Queries may be made from several threads.
class NearestTriangle {
 public:
  /// @param mesh  must outlive this; at least one triangle
  /// @throws InvalidInput if it has none
  explicit NearestTriangle(const Mesh& mesh);

  /// The nearest point of the mesh; of equally near triangles, the point on the triangle of the lowest index.
  NearestPlace nearest(const Point3& point) const;

  /// The same, but nothing if no point of the mesh is nearer than `within_mm`.
  std::optional<NearestPlace> nearest(const Point3& point, double within_mm) const;

 private:
  struct Node {
    Box3 box;
    std::uint32_t first = 0;  // index of the first triangle of a leaf, otherwise number of the right child
    std::uint32_t count = 0;  // 0 for an inner node, whose left child follows it
  };
  struct Search;

  std::uint32_t build(std::uint32_t first, std::uint32_t last, const std::vector<Point3>& middles);
  void visit(std::uint32_t node, Search& search) const;

  const Mesh& mesh_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

/// The point of a triangle nearest to a point.
Point3 nearestInTriangle(const Point3& point, const Point3& a, const Point3& b, const Point3& c);

}  // namespace lamina
