// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Notices a sensor that says the same all the time, or nothing: profiles of a moving sensor in a row that
/// are the same at each of their points, or of no numbers, or of zeros.
class StuckWatch {
 public:
  /// A profile that was taken while the sensor moved. One without points changes nothing: out of range.
  /// @param points  [mm, frame of the sensor]; not finite where there is none
  void see(const std::vector<Point3>& points);

  /// Profiles in a row that say nothing new.
  int profiles() const { return profiles_; }
  /// Greatest variance among those of a point to the profile before [mm²]; 0 without numbers.
  double variance() const { return variance_mm2_; }

 private:
  std::vector<Point3> last_;
  int profiles_ = 0;
  double variance_mm2_ = 0.0;
};

}  // namespace lamina
