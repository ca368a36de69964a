// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// A closed line with the inward normal at each point.
struct NormalLoop {
  Polygon points;
  std::vector<Point2> inward;  ///< unit vector at each point, towards the material
};

/// The outline with additional points, as few as possible and evenly spaced between its own, so that
/// neighbours are at most `longest_step_mm` apart [Flores2018, figures 40 and 41]. The normal at a point of
/// the outline is the mean of the normals of its two edges; at points between, it changes evenly from one end
/// to the other. Points closer than 1e-9 mm to the one before are left out.
NormalLoop withNormals(const Polygon& outline, double longest_step_mm);

/// The outline with each point moved along its normal, as for several perimeters in [Flores2018, section
/// 6.2.1]. The result crosses itself where the radius of the outline is less than the distance.
Polygon movedInwards(const NormalLoop& loop, double distance_mm);

}  // namespace lamina
