// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Cross-section of a bead as a height map sees it.
struct BeadSection {
  double width_mm = 0.0;
  double thickness_mm = 0.0;  ///< from the ground to the nozzle
  double edge_mm = 0.0;       ///< over which the edge falls to the ground beyond the width
};

/// Height of the bead's top above its underside at a distance from its centre line [mm]: a stadium where the
/// bead is at least as wide as thick, otherwise a disc as wide as the bead. Grows steadily with the width.
double topAbove(const BeadSection& section, double distance);

/// Width of the bead of that cross-sectional area [mm²] between flat ground and a nozzle `thickness` above
/// it.
double widthOnFlatGround(double area, double thickness);

/// Diameter of a free strand of that cross-sectional area [mm²].
double discDiameter(double area);

}  // namespace lamina
