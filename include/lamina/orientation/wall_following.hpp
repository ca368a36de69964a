// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/wall_normals.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Tool axes of a run along a wall, and the number of waypoints without a wall to follow.
struct WallToolAxes {
  std::vector<Point3> tool_axes;  ///< one per waypoint, of unit length
  std::size_t waypoints_without_wall =
      0;  ///< where the tool axis of a neighbour stands, or the given one if none has any
};

/// The tool axis that lies in the wall and across the path, as near to the layer's normal as possible
/// [Flores2018, figures 42 and 43]. With X the path's tangent in the layer and Y the wall's normal, it is X x
/// Y or its opposite, whichever points into the layer: the direction of the path does not matter. A wall
/// whose normal is within 30 degrees of the path's direction has no tool axis across the path: such a
/// waypoint is without a wall.
///
/// @param path  with the orientations the slicer gave, whose tool axes are against the layer's normal
WallToolAxes wallFollowingToolAxes(const Path& path, const WallNormals& walls);

}  // namespace lamina
