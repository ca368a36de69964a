// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <complex>
#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"

namespace lamina {

/// Measure of how much the triangles of a parameterization are distorted: the sum over all sides of the
/// squared difference from the undistorted side, with the triangle rotated at best, times the cotangent of
/// the opposite angle ("as rigid as possible" [Liu2008]). Slivers count as if their height were a hundredth
/// of their length.
class ArapEnergy {
 public:
  /// A triangle laid flat on its own: its sides as vectors from corner to corner, and the weight of each.
  struct FlatTriangle {
    std::array<std::complex<double>, 3> side;
    std::array<double, 3> weight{};
  };

  /// The sum, and half of its negative gradient with the rotations held fixed.
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
