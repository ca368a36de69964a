// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// A point of a medial axis, with its clearance: the distance to the nearest point of the border [mm].
struct AxisPoint {
  Point2 point;
  double radius_mm = 0.0;
};

/// A line of the medial axis between two nodes, which are its first and last point.
struct AxisBranch {
  std::size_t from = 0;
  std::size_t to = 0;
  std::vector<AxisPoint> points;  ///< at least two; only one if pruning left a single point of an axis
};

/// The medial axis of a region, that is all points that have more than one nearest point on its border, as a
/// graph: branches end or meet in nodes. A branch that closes on itself has the same node at both ends.
struct MedialAxis {
  std::vector<AxisPoint> nodes;
  std::vector<AxisBranch> branches;
};

/// Computes the medial axis of a region from the Voronoi diagram of its edges (Boost.Polygon): exact where
/// two edges or two corners are nearest, within `tolerance_mm` of the parabola where an edge and a corner
/// are. The radius varies linearly between points within the same tolerance.
///
/// Points are rounded to a grid of 1e-5 mm. Outlines that touch or cross, repeated points and outlines
/// without area are accepted as they are; a region without area has no axis. The same region gives the same
/// axis.
/// @throws InvalidInput if the region is larger than 20 m, or the tolerance is not positive
MedialAxis medialAxis(const Region& region, double tolerance_mm = 0.005);

/// Which ends of a medial axis are cut off as irrelevant. An end reaches from a tip along the axis to where
/// the clearance stops growing, or to the next node if that comes first.
struct AxisPruning {
  /// Ends that reach no farther than this beyond the disc of clearance at their inner end are cut off [mm].
  double least_reach_mm = 0.0;
  /// Ends in corners of at least this angle are cut off [rad]; pi for none.
  double widest_corner_rad = 2.0 * 3.14159265358979323846 / 3.0;
};

/// The axis without the ends that `pruning` describes. A node where only two branches are left is dissolved
/// into one branch. Each connected axis keeps at least a point.
MedialAxis pruned(const MedialAxis& axis, const AxisPruning& pruning);

/// The path through a connected axis from one tip to the tip farthest from it, as the only branch of the
/// result: a diameter of a disc, a diagonal of a square. An axis without tips is returned unchanged.
MedialAxis farthestWay(const MedialAxis& axis);

}  // namespace lamina
