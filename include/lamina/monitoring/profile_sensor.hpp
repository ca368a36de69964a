// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "lamina/base/random.hpp"
#include "lamina/base/settings.hpp"
#include "lamina/geometry/voxel/height_source.hpp"

namespace lamina {

/// A laser-profile sensor: a fan of rays from the sensor's origin in its x-z plane, z along the viewing
/// direction.
struct ProfileSensorSettings {
  double width_mm = 30.0;      ///< of the line of light at the stand-off
  int points = 300;            ///< rays in the fan
  double stand_off_mm = 60.0;  ///< distance along z at which the line has its width
  double range_mm = 40.0;      ///< depth of the measuring range, half before and half beyond the stand-off
  double noise_mm = 0.01;      ///< standard deviation along z
  int seed = 1;                ///< of the noise
};

/// Adds the keys sensor.*.
void describe(SettingsSchema& schema, ProfileSensorSettings& settings);

/// Simulates the sensor over a surface of heights.
class ProfileSensor {
 public:
  /// @throws InvalidConfig if the settings leave no range
  explicit ProfileSensor(const ProfileSensorSettings& settings);

  /// What the sensor sees: where each ray first meets the surface [mm, sensor frame], in the order of the
  /// fan. Rays that meet nothing known within the range give no point. The columns of the surface cast
  /// shadows.
  ///
  /// @param highest  height above which the surface has nothing [mm]: spares the search there
  std::vector<Point3> measure(const HeightSource& surface, const Eigen::Isometry3d& bed_from_sensor,
                              double highest = std::numeric_limits<double>::infinity());
  std::vector<Point3> measure(const HeightMap& surface, const Eigen::Isometry3d& bed_from_sensor,
                              double highest = std::numeric_limits<double>::infinity()) {
    return measure(sourceOf(surface), bed_from_sensor, highest);
  }

 private:
  ProfileSensorSettings settings_;
  Random random_;
};

}  // namespace lamina
