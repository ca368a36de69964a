// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// A point of a medial axis and its clearance: the distance to the nearest point of the border [mm].
struct AxisPoint {
  Point2 point;
  double radius_mm = 0.0;
};

/// A line of the medial axis between two nodes, which are its first and last point.
struct AxisBranch {
  std::size_t from = 0;
  std::size_t to = 0;
  std::vector<AxisPoint> points;  ///< at least two; one alone if all of an axis was pruned but this
};

/// The points of a region that have more than one nearest point on its border, as a graph: nodes where
/// branches end or meet. A branch that closes on itself has the same node at both ends.
struct MedialAxis {
  std::vector<AxisPoint> nodes;
  std::vector<AxisBranch> branches;
};

/// The medial axis of a region, from the Voronoi diagram of its edges (Boost.Polygon): exact where two edges
/// or two corners are nearest, within `tolerance_mm` of the parabola where an edge and a corner are. The
/// radius varies linearly between points within the same tolerance.
///
/// Works on a grid of 1e-5 mm. Outlines that touch or cross, points that stand twice and outlines without
/// area are taken as they lie; a region without area has no axis. The same region gives the same axis.
/// @throws InvalidInput if the region is larger than 20 m, or the tolerance not positive
MedialAxis medialAxis(const Region& region, double tolerance_mm = 0.005);

/// Which ends of a medial axis are not worth following.
struct AxisPruning {
  /// Ends that reach no farther than this beyond the largest disc inside the region beside them [mm].
  double least_reach_mm = 0.0;
  /// Ends in corners as wide as this, or wider [rad]; pi for none.
  double widest_corner_rad = 2.0 * 3.14159265358979323846 / 3.0;
};

/// The axis without those ends. What is cut runs from a tip to where the radius grows no more, at the latest
/// to the next node. Nodes where two branches are left vanish. Each connected axis keeps a point at least.
MedialAxis pruned(const MedialAxis& axis, const AxisPruning& pruning);

/// The way through a connected axis from one tip to the tip farthest from it, as the only branch: of a disc a
/// diameter, of a square a diagonal. An axis without tips stays as it is.
MedialAxis farthestWay(const MedialAxis& axis);

}  // namespace lamina
