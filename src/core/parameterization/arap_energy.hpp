// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <complex>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// How far the triangles of a parameterization are from keeping their shape: the sum over the sides of
/// (difference from the side as it is when the triangle is turned at best)² times the cotangent of the angle
/// across it ("as rigid as possible" [Liu2008]). Slivers count as if they were a hundredth as high as long.
class ArapEnergy {
 public:
  /// A triangle laid flat by itself: its sides as vectors from corner to corner, and how much each counts.
  struct FlatTriangle {
    std::array<std::complex<double>, 3> side;
    std::array<double, 3> weight{};
  };

  /// The sum, and half of minus its gradient with the turns held.
  struct Pull {
    double energy = 0.0;
    std::vector<Point2> at_vertex;
  };

  /// @param surface  [mm] must outlive this
  explicit ArapEnergy(const Mesh& surface);

  Pull pullOn(const std::vector<Point2>& parameterization) const;

  const Mesh& surface() const { return surface_; }
  const std::vector<FlatTriangle>& triangles() const { return triangles_; }

 private:
  const Mesh& surface_;
  std::vector<FlatTriangle> triangles_;
};

}  // namespace lamina
