// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Parts that hang over, in layers of 0.2 mm.
#pragma once

#include <cmath>
#include <vector>

#include "support/planned_layers.hpp"
#include "support/shapes.hpp"

namespace lamina::test {

/// A stem of 10 x 40 x 20 mm with a slab of 40 x 40 x 5 mm on it.
inline std::vector<Layer> tee() {
  return layersOf(125, [](int l) {
    return std::vector<Polygon>{l < 100 ? rectangle(-5, -20, 5, 20) : rectangle(-20, -20, 20, 20)};
  });
}

constexpr double kSphereRadius = 8.0;  // mm

/// Of the section of a sphere that stands on the bed, in that layer; 0 above it.
inline double sphereRadiusIn(std::size_t layer) {
  const double z = kLayerHeight * (static_cast<double>(layer) + 0.5);
  return std::sqrt(std::max(0.0, kSphereRadius * kSphereRadius - (z - kSphereRadius) * (z - kSphereRadius)));
}

/// Pillars and a roof of 40 x 20 mm over a sphere of 8 mm; or both without the roof.
inline std::vector<Layer> archOverSphere(double roof_mm = 4.0) {
  return layersOf(100 + static_cast<int>(std::lround(roof_mm / kLayerHeight)), [](int l) {
    if (l >= 100) return std::vector<Polygon>{rectangle(-20, -10, 20, 10)};
    std::vector<Polygon> contours{rectangle(-20, -10, -14, 10), rectangle(14, -10, 20, 10)};
    const double radius = sphereRadiusIn(static_cast<std::size_t>(l));
    if (radius > 0.1) contours.push_back(circle({0, 0}, radius, 90));
    return contours;
  });
}

}  // namespace lamina::test
