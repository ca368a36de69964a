// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "lamina/geometry/vector.hpp"
#include "lamina/sweep/sweep.hpp"
#include "toolpath/bead_space.hpp"

namespace lamina {

/// Frame of the profile of one line of a sweep.
struct BeadFrame {
  Point3 middle;  ///< middle of the profile at the start of the line [mm]
  Point3 way;     ///< vector to the end of the line [mm]
  Point3 side;    ///< horizontal direction across the line, of unit length
  Point3 up;      ///< direction across line and side, of unit length
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
