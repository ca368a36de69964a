// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Detects a sensor that is stuck: profiles in a row, taken while it moves, that are all the same at each
/// point, not finite, or zero.
class StuckWatch {
 public:
  /// Takes a profile of the moving sensor. A profile without points, out of range, changes nothing.
  /// @param points  [mm, frame of the sensor]; not finite where one is missing
  void see(const std::vector<Point3>& points);

  /// Number of such profiles in a row.
  int profiles() const { return profiles_; }
  /// Greatest variance of a point between successive ones of them [mm²]; 0 without finite points.
  double variance() const { return variance_mm2_; }

 private:
  std::vector<Point3> last_;
  int profiles_ = 0;
  double variance_mm2_ = 0.0;
};

}  // namespace lamina
