// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/wall_normals.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Tool axes of a run along a wall and how many of them had no wall to follow.
struct WallToolAxes {
  std::vector<Point3> tool_axes;  ///< one per waypoint, of unit length
  std::size_t waypoints_without_wall =
      0;  ///< where the tool axis of a neighbour stands, or the given one if none has any
};

/// The tool axis that lies in the wall and across the path, as near to the layer's normal as it can
/// [Flores2018, figures 42 and 43]: X is the path's tangent in the layer, Y the wall's normal, the
/// tool axis X x Y, turned such that it points into the layer, whichever way the path runs. A wall whose
/// normal is within 30 degrees of the path's direction has no tool axis across the path: such a waypoint is
/// without a wall.
///
/// @param path  with the orientations the slicer gave, whose tool axes are against the layer's normal
WallToolAxes wallFollowingToolAxes(const Path& path, const WallNormals& walls);

}  // namespace lamina
