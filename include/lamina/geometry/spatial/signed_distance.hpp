// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "lamina/geometry/spatial/nearest_triangle.hpp"

namespace lamina {

/// Signed distance of a point to a closed mesh.
struct SignedPlace {
  double inside_mm = 0.0;  ///< distance to the surface [mm]; positive inside, negative outside
  NearestPlace nearest;
};

/// Signed distances to a closed mesh that faces outwards. The sign follows from the pseudonormal at the
/// nearest point of the mesh [Baerentzen2005]: the normal of a face, the sum of both faces' normals on an
/// edge, the sum weighted by angles at a vertex. Exact up to rounding; where the mesh is open or passes
/// through itself, the sign is that of the nearest face.
class SignedDistance {
 public:
  /// @param mesh  must outlive this; at least one triangle
  /// @throws InvalidInput if it has none
  explicit SignedDistance(const Mesh& mesh);

  SignedPlace at(const Point3& point) const;

  const NearestTriangle& surface() const { return tree_; }

 private:
  Point3 pseudonormal(const NearestPlace& place) const;

  const Mesh& mesh_;
  NearestTriangle tree_;
  std::vector<Point3> of_triangle_;
  std::vector<std::array<Point3, 3>> of_side_;
  std::vector<Point3> of_vertex_;
};

}  // namespace lamina
