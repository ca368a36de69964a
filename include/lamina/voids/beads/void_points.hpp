// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// Where another drop would find room.
struct VoidPoint {
  Point2 position = Point2::Zero();  ///< [mm]
  double clearance_mm = 0.0;         ///< distance to the nearest drop's centre
};

/// How void points are found [Sobreviela2014, section 4.1].
enum class VoidDetector {
  Voronoi,     ///< the vertices of the Voronoi diagram of all drops: equally far from three of them or more
  Neighbours,  ///< beside drops whose neighbours leave a gap of more than 95 degrees, in the middle of it
};

/// What void points are searched for.
struct VoidSearch {
  double diameter_mm = 0.0;        ///< of a drop, positive
  double least_distance_mm = 0.0;  ///< from a new drop to any other, centre to centre
};

/// Places with at least that distance to all drops (within a millionth of the diameter), by x and then y,
/// none closer than that rounding to another. Outside the drops there are such places too: see `inside`.
/// @param drops  centres; of those at one place one counts. Fewer than three give nothing.
std::vector<VoidPoint> findVoidPoints(VoidDetector detector, const std::vector<Point2>& drops,
                                      const VoidSearch& search);

/// Those inside the outlines by the even-odd rule.
std::vector<VoidPoint> inside(const std::vector<Polygon>& borders, const std::vector<VoidPoint>& points);

}  // namespace lamina
