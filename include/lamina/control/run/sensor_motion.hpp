// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <optional>

#include "lamina/geometry/vector.hpp"

namespace lamina {

/// Measures the velocity of the sensor from one cloud to the next.
class SensorMotion {
 public:
  /// Adds the position of the sensor at a cloud [mm].
  void see(std::int64_t stamp_ns, const Point3& at);
  /// Velocity between the last two clouds [mm/s]; zero if these are more than half a second apart, since the
  /// sensor may have turned in between.
  const Eigen::Vector3d& velocity() const { return velocity_; }

 private:
  Point3 at_ = Point3::Zero();
  std::optional<std::int64_t> stamp_ns_;
  Eigen::Vector3d velocity_ = Eigen::Vector3d::Zero();
};

}  // namespace lamina
