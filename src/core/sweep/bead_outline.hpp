// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/geometry/vector.hpp"
#include "lamina/sweep/sweep.hpp"
#include "toolpath/bead_space.hpp"

namespace lamina {

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
  frame.middle = sectionMiddle(sweep.points[line], sweep.bead.height_mm, up);
  frame.way = sweep.points[line + 1] - sweep.points[line];
  frame.side = frame.way.cross(up).normalized();
  frame.up = frame.side.cross(frame.way).normalized();
  return frame;
}

}  // namespace lamina
