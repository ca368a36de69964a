// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "lamina/geometry/mesh.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Outward normals of the walls of a part, found near a path. Faces that lean too far are no walls, so that
/// the top of a part is not taken for one where a wall runs along it. Queries may be made from several
/// threads.
class WallNormals {
 public:
  /// @param part          triangles that face outwards [mm, part frame]; need not outlive this
  /// @param up            normal of the layers, of unit length
  /// @param max_lean_deg  greatest angle between a wall and `up`
  /// @throws InvalidInput if no face of the part is a wall
  WallNormals(const Mesh& part, const Point3& up, double max_lean_deg);
  ~WallNormals();
  WallNormals(WallNormals&&) noexcept;
  WallNormals& operator=(WallNormals&&) noexcept;

  /// Normal at the place of the walls nearest to a point, of unit length: that of its triangle in the middle
  /// of it, at an edge the mean of both triangles if they bend by less than 45 degrees.
  Point3 at(const Point3& point) const;

 private:
  struct Walls;
  std::unique_ptr<Walls> walls_;
};

/// Jets of a run along a wall and how many of them had no wall to follow.
struct WallJets {
  std::vector<Point3> jets;  ///< one per waypoint, of unit length
  std::size_t waypoints_without_wall =
      0;  ///< where the jet of a neighbour stands, or the given one if none has any
};

/// The jet that lies in the wall and across the path, as near to the layer's normal as it can
/// (metal-deposition-paths.md section 2.3): X is the path's tangent in the layer, Y the wall's normal, the
/// jet X x Y, turned such that it points into the layer, whichever way the path runs. A wall whose normal is
/// within 30 degrees of the path's direction has no jet across the path: such a waypoint is without a wall.
///
/// @param path  with the orientations the slicer gave, whose jets are against the layer's normal
WallJets wallFollowingJets(const Path& path, const WallNormals& walls);

}  // namespace lamina
