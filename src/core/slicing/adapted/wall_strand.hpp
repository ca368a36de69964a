// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// A flat contour of a wall: a loop of points at one height, with the direction upwards along the wall at
/// each point.
struct WallContour {
  std::vector<Point3> points;
  std::vector<Point3> axis;
};

/// One wall from bottom to top: its contour at each height.
struct WallStrand {
  std::vector<WallContour> levels;
};

/// The walls of a part, cut at the given heights. Points of a contour are at most `step_mm` apart.
/// @param heights  ascending; the first at the bottom of the part, the last just below its top
/// @throws Unsliceable if the number of loops changes from one height to the next; InvalidMesh if a contour
/// is open
std::vector<WallStrand> wallStrands(const Mesh& mesh, const std::vector<double>& heights, double step_mm,
                                    Progress& progress);

}  // namespace lamina
