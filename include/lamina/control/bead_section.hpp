// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A point of the upper contour of a bead.
struct ContourPoint {
  double across_mm = 0.0;  ///< from the bead's middle
  double below_mm = 0.0;   ///< below the planned top, along the growth direction
};

/// How far the contour of a stadium lies below its top [mm].
double plannedDepth(double across_mm, const Bead& bead);

/// Missing cross-section of a bead, from its upper contour, as a share of the planned cross-section; negative
/// if there is too much. It is measured below the bead's own crown and above its planned base, so that
/// neither the height of the nozzle nor settling counts. Each point stands for a strip as wide as the mean
/// spacing of points. The strip lacks the depth of its point below the planned stadium at that place: a bead
/// as planned lacks nothing, wherever the points lie. A bead that is too wide shows by its shoulders alone,
/// up to (1/2 - pi/8) h² / A; flanks in shadow count as planned.
/// @param contour  points within half the bead's width of its middle
/// @return nothing if there are fewer than five points, none on the crown (the middle third), or none beyond
///   three tenths of the width on either side
std::optional<double> sectionDeficit(const std::vector<ContourPoint>& contour, const Bead& bead);

}  // namespace lamina
