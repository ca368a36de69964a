// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "deposition/bead_section.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {

double topAbove(const BeadSection& section, double distance) {
  const double half = 0.5 * section.width_mm;
  const double flat = std::max(half - 0.5 * section.height_mm, 0.5 * std::min(half, section.cell_mm));
  const double rounding = half - flat;
  // A bead narrower than a cell is lower, so that one of no width is none.
  const double middle = 0.5 * section.height_mm * std::min(1.0, section.width_mm / section.cell_mm);
  if (distance > half) return std::max(0.0, middle * (1.0 - (distance - half) / section.cell_mm));
  if (distance <= flat) return 2.0 * middle;
  const double along = (distance - flat) / rounding;
  return middle * (1.0 + std::sqrt(1.0 - along * along));
}

double discDiameter(double area) { return 2.0 * std::sqrt(area / M_PI); }

double widthOnFlatGround(double area, double thickness) {
  const double disc = discDiameter(area);
  return disc <= thickness ? disc : area / thickness + thickness * (1.0 - 0.25 * M_PI);
}

}  // namespace lamina
