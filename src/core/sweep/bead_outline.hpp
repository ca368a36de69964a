// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <algorithm>

#include "lamina/geometry/vector.hpp"
#include "lamina/sweep/sweep.hpp"

namespace lamina {

/// The stadium of a bead about its middle.
struct BeadOutline {
  double flat_across_mm = 0.0;  ///< half of its level straight lines; 0 if it is higher than wide
  double flat_up_mm = 0.0;      ///< half of its upright ones
  double radius_mm = 0.0;
};

inline BeadOutline outlineOf(const Bead& bead) {
  const double radius_mm = 0.5 * std::min(bead.width_mm, bead.height_mm);
  return {0.5 * bead.width_mm - radius_mm, 0.5 * bead.height_mm - radius_mm, radius_mm};
}

/// Where the profile of one line of a sweep stands.
struct BeadFrame {
  Point3 middle;  ///< of the profile at the start of the line [mm]
  Point3 way;     ///< to the end of the line [mm]
  Point3 side;    ///< unit, across the line
  Point3 up;      ///< unit, across both
};

/// @param line  of the sweep, from 0
inline BeadFrame frameOfLine(const Sweep& sweep, std::size_t line) {
  const Point3& up = sweep.up[line + 1];
  BeadFrame frame;
  frame.middle = sweep.points[line] - 0.5 * sweep.bead.height_mm * up;
  frame.way = sweep.points[line + 1] - sweep.points[line];
  frame.side = frame.way.cross(up).normalized();
  frame.up = frame.side.cross(frame.way).normalized();
  return frame;
}

}  // namespace lamina
