// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
// Parts of which it is known how they grow.
#pragma once

#include <cmath>

#include "lamina/geometry/mesh/extrusion.hpp"
#include "lamina/geometry/parts/parts.hpp"
#include "support/shapes.hpp"

namespace lamina::test {

/// A prism that lies: a profile in x and z, from y = -depth / 2 to depth / 2.
inline Mesh lyingPrism(const Region& profile, double depth_mm) {
  Mesh mesh = extruded({profile}, depth_mm);
  for (Point3& vertex : mesh.vertices) vertex = Point3(vertex.x(), 0.5 * depth_mm - vertex.z(), vertex.y());
  return mesh;
}

/// A stem 12 mm wide and 20 mm high, and on it a bar as thick as it says that reaches 12 mm beyond on both
/// sides.
inline Mesh tShape(double bar_mm = 6.0) {
  const double top = 20.0 + bar_mm;
  return lyingPrism({{{-6, 0}, {6, 0}, {6, 20}, {18, 20}, {18, top}, {-18, top}, {-18, 20}, {-6, 20}}, {}},
                    8.0);
}

/// A stem 12 mm wide and 20 mm high, and two arms 8 mm deep and high that lean out from its corners by 60 deg
/// from upright.
inline Mesh yShape() {
  const double rise = 15.0 / std::tan(M_PI / 3.0);
  const double notch = 28.0 - 6.0 / std::tan(M_PI / 3.0);
  return lyingPrism({{{-6, 0},
                      {6, 0},
                      {6, 20},
                      {21, 20 + rise},
                      {21, 28 + rise},
                      {0, notch},
                      {-21, 28 + rise},
                      {-21, 20 + rise},
                      {-6, 20}},
                     {}},
                    8.0);
}

/// A frustum that opens upwards, its wall `lean_deg` from upright, on a circle of 10 mm.
inline Mesh openingFrustum(double lean_deg, double height_mm) {
  const double top = 10.0 + height_mm * std::tan(lean_deg * M_PI / 180.0);
  return makePart("cone", {{"radius_mm", "10"},
                           {"top_radius_mm", std::to_string(top)},
                           {"height_mm", std::to_string(height_mm)},
                           {"segments", "256"}});
}

}  // namespace lamina::test
