// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/stiffness/element_stiffness.hpp"

#include <array>
#include <cstddef>

namespace lamina {
namespace {

/// Integral over [0, 1] of the product of two linear functions of one axis, or of their derivatives.
/// Function 0 falls from 1 to 0, function 1 rises.
double lineIntegral(int a, bool a_derived, int b, bool b_derived) {
  if (a_derived && b_derived) return a == b ? 1.0 : -1.0;
  if (a_derived) return a == 1 ? 0.5 : -0.5;
  if (b_derived) return b == 1 ? 0.5 : -0.5;
  return a == b ? 1.0 / 3.0 : 1.0 / 6.0;
}

/// Integral over the unit cube of the product of the derivatives of two corner functions.
double cubeIntegral(int a, int along_a, int b, int along_b) {
  double product = 1.0;
  for (int axis = 0; axis < 3; ++axis)
    product *= lineIntegral(a >> axis & 1, axis == along_a, b >> axis & 1, axis == along_b);
  return product;
}

}  // namespace

ElementMatrix elementStiffness(const ElasticMaterial& material, double element_mm) {
  const double lambda = material.lambda();
  const double mu = material.mu();
  ElementMatrix stiffness;
  for (int a = 0; a < 8; ++a)
    for (int b = 0; b < 8; ++b) {
      const double gradients = cubeIntegral(a, 0, b, 0) + cubeIntegral(a, 1, b, 1) + cubeIntegral(a, 2, b, 2);
      for (int p = 0; p < 3; ++p)
        for (int q = 0; q < 3; ++q)
          stiffness(3 * a + p, 3 * b + q) =
              element_mm * (lambda * cubeIntegral(a, p, b, q) + mu * cubeIntegral(a, q, b, p) +
                            (p == q ? mu * gradients : 0.0));
    }
  return stiffness;
}

}  // namespace lamina
