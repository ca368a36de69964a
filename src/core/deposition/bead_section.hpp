// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Cross-section of a bead as a height map sees it.
struct BeadSection {
  double width_mm = 0.0;
  double height_mm = 0.0;
  double cell_mm = 0.0;  ///< of the map: over this length the edge falls to the ground beyond the width
};

/// Height of the bead's top above its underside at a distance from its centre line [mm]: a stadium, whose
/// flat top is as wide as a cell of the map where the bead is twice as wide, so that some cell is as high as
/// the bead. Grows steadily with the width.
double topAbove(const BeadSection& section, double distance);

/// Width of the bead of that cross-sectional area [mm²] between flat ground and a nozzle `thickness` above
/// it.
double widthOnFlatGround(double area, double thickness);

/// Diameter of a free strand of that cross-sectional area [mm²].
double discDiameter(double area);

}  // namespace lamina
