// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Detects a sensor that is stuck: while it moves it gives several profiles in a row that are equal at each
/// point, or that have no finite point other than zero. Up to `kRemembered` sensors that are all stuck are
/// detected as well: each profile equals one of the last ones.
class StuckWatch {
 public:
  /// Number of different profiles that a further one is compared with.
  static constexpr std::size_t kRemembered = 4;

  /// Adds a profile of the moving sensor. A profile without points, out of range, has no effect.
  /// @param points  [mm, frame of the sensor]; not finite where one is missing
  void see(const std::vector<Point3>& points);

  /// Number of equal profiles in a row, the last one included: 1 as long as the sensor is not stuck.
  int profiles() const { return profiles_; }
  /// Greatest variance of a point between two equal profiles of these [mm²]; 0 without finite points.
  double variance() const { return variance_mm2_; }

 private:
  double leastVariance(const std::vector<Point3>& points);
  void remember(const std::vector<Point3>& points);

  std::vector<std::vector<Point3>> last_;  ///< different ones, that seen last at the end
  int profiles_ = 0;
  double variance_mm2_ = 0.0;
};

}  // namespace lamina
