// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "deposition/bead_section.hpp"

#include <algorithm>
#include <cmath>

namespace lamina {

double topAbove(const BeadSection& section, double distance) {
  const double half = 0.5 * section.width_mm;
  const double radius = 0.5 * std::min(section.width_mm, section.thickness_mm);
  const double from_flat = distance - (half - radius);
  if (from_flat <= 0.0) return 2.0 * radius;
  if (from_flat <= radius) return radius + std::sqrt(radius * radius - from_flat * from_flat);
  return std::max(0.0, radius * (1.0 - (distance - half) / section.edge_mm));
}

double discDiameter(double area) { return 2.0 * std::sqrt(area / M_PI); }

double widthOnFlatGround(double area, double thickness) {
  const double disc = discDiameter(area);
  return disc <= thickness ? disc : area / thickness + thickness * (1.0 - 0.25 * M_PI);
}

}  // namespace lamina
