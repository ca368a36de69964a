// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// A point between drops at which there is room for another one.
struct VoidPoint {
  Point2 position = Point2::Zero();  ///< [mm]
  double clearance_mm = 0.0;         ///< distance to the centre of the nearest drop
};

/// How void points are found [Sobreviela2014, section 4.1].
enum class VoidDetector {
  Voronoi,     ///< vertices of the Voronoi diagram of all drops, equally far from at least three of them
  Neighbours,  ///< middle of an angle of more than 95 degrees in which a drop has no neighbour
};

/// Size and distance of the drops for which void points are searched.
struct VoidSearch {
  double diameter_mm = 0.0;        ///< of a drop, positive
  double least_distance_mm = 0.0;  ///< from the centre of a new drop to that of any other
};

/// The void points with at least the least distance to all drops, within a millionth of the diameter. They
/// are in the order of x and then y, and no two are closer to each other than this tolerance. There are void
/// points outside of the drops, too; `inside` removes them.
/// @param drops  centres; coincident ones count once. Fewer than three drops have no void points.
std::vector<VoidPoint> findVoidPoints(VoidDetector detector, const std::vector<Point2>& drops,
                                      const VoidSearch& search);

/// The points that are inside of the outlines by the even-odd rule.
std::vector<VoidPoint> inside(const std::vector<Polygon>& borders, const std::vector<VoidPoint>& points);

}  // namespace lamina
