// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// Cross-section of a bead, sampled by a height map.
struct BeadSection {
  double width_mm = 0.0;
  double height_mm = 0.0;
  /// Cell size of the map; beyond the width, the edge falls to the ground over this length.
  double cell_mm = 0.0;
};

/// Height of the bead's top above its underside at a distance from the centre line [mm]. The section is a
/// stadium, whose flat top is at least as wide as a cell of the map if the bead is twice as wide, so that
/// some cell has the height of the bead. Grows continuously with the width.
double topAbove(const BeadSection& section, double distance);

/// Width of a bead with that cross-sectional area [mm²] between flat ground and a nozzle `thickness` above it
/// [mm].
double widthOnFlatGround(double area, double thickness);

/// Diameter of a free strand with that cross-sectional area [mm²].
double discDiameter(double area);

}  // namespace lamina
