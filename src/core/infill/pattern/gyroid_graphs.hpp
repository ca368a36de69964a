// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// A level section of sin x cos y + sin y cos z + sin z cos x = 0 as the graphs of two functions (branches),
/// each repeated every 2 pi. Solved for one coordinate v, the equation is a cos v + b sin v + c = 0, so that
/// v = atan2(b, a) +- acos(-c / sqrt(a² + b²)). With v = y this has a solution at every x if |sin z| <= |cos
/// z|; at other heights v = x has one at every y.
class GyroidGraphs {
 public:
  /// @param z  height as a phase: 2 pi for each cell
  explicit GyroidGraphs(double z);

  /// Whether the graphs are y over x; otherwise they are x over y.
  bool isOverX() const;

  /// Value of a branch at t; continuous, with period 2 pi.
  /// @param branch  -1 or 1
  double at(double t, int branch) const;

 private:
  double sin_z_, cos_z_;
};

}  // namespace lamina
