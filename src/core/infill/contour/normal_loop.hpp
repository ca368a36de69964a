// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/geometry/polygon/polygon.hpp"

namespace lamina {

/// A closed line of which each point knows where its inside lies.
struct NormalLoop {
  Polygon points;
  std::vector<Point2> inward;  ///< unit vector at each point, towards the material
};

/// The outline with the fewest points more, evenly between those it has, so that no two neighbours are
/// farther apart than `longest_step_mm` [Flores2018, figures 40 and 41]. The normal of its own points is the
/// mean of those of both edges, of those in between it goes over from one to the other. Points nearer to the
/// one before than 1e-9 mm are left out.
NormalLoop withNormals(const Polygon& outline, double longest_step_mm);

/// Each point moved along its normal, as for several perimeters in [Flores2018, section 6.2.1]. Crosses
/// itself where the outline bends more sharply than that.
Polygon movedInwards(const NormalLoop& loop, double distance_mm);

}  // namespace lamina
