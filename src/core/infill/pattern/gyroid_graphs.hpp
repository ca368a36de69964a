// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace lamina {

/// The level cut through sin x cos y + sin y cos z + sin z cos x = 0 as graphs of two branches, each repeated
/// every 2 pi. Solved for one coordinate, the equation reads a cos v + b sin v + c = 0, and v = atan2(b, a)
/// +- acos(-c / sqrt(a² + b²)). For v = y this holds at every x where |sin z| <= |cos z|; at other heights
/// for v = x at every y.
class GyroidGraphs {
 public:
  /// @param z  in phases: 2 pi over a cell
  explicit GyroidGraphs(double z);

  /// Whether the graphs are y over x; otherwise they are x over y.
  bool isOverX() const;

  /// Continuous, and the same after 2 pi.
  /// @param branch  -1 or 1
  double at(double t, int branch) const;

 private:
  double sin_z_, cos_z_;
};

}  // namespace lamina
