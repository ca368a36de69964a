// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// Outward normals of the walls of a part, found near a path. Faces that lean too far do not count as walls,
/// so that the top of a part is not taken for a wall that runs along its edge. Queries may be made from
/// several threads.
class WallNormals {
 public:
  /// @param part          triangles that face outwards [mm, part frame]; need not outlive this object
  /// @param up            normal of the layers, of unit length
  /// @param max_lean_deg  greatest angle between a wall and `up`
  /// @throws InvalidInput if no face of the part is a wall
  WallNormals(const Mesh& part, const Point3& up, double max_lean_deg);
  ~WallNormals();
  WallNormals(WallNormals&&) noexcept;
  WallNormals& operator=(WallNormals&&) noexcept;

  /// Normal of the walls at their point nearest to `point`, of unit length: the triangle's normal in the
  /// middle of a triangle, changing towards an edge to the mean of both normals if they differ by less than
  /// 45 degrees.
  Point3 at(const Point3& point) const;

 private:
  struct Walls;
  std::unique_ptr<Walls> walls_;
};

}  // namespace lamina
