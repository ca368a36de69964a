// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <limits>
#include <optional>
#include <vector>

#include "lamina/base/random.hpp"
#include "lamina/base/settings_schema.hpp"
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
  int seed = 1;                ///< of the random numbers of noise and defects
  // Defects of the sensor; by default it has none.
  double noise_correlation = 0.0;  ///< of the noise, from one point to the next
  double lateral_noise_mm = 0.0;   ///< standard deviation of points along the line of light
  double time_offset_s = 0.0;      ///< stamp less true time
  double stamp_jitter_s = 0.0;     ///< standard deviation of time stamps
  double spray_rate = 0.0;         ///< share of points between sensor and surface, as from spray
  double mirror_rate = 0.0;        ///< share of rays that give a second point, behind the surface
  double dropout_rate = 0.0;       ///< share of points that are missing
  double bias_mm = 0.0;            ///< added to depths
  double drift_mm_h = 0.0;         ///< added to depths per hour
  /// Displacement of the sensor from its assumed position: along its line, across it, along its beam; empty
  /// or three values.
  std::vector<double> moved_mm = {};
  double moved_at_s = 0.0;  ///< time from which on it is displaced
};

/// Adds the keys sensor.*.
void describe(SettingsSchema& schema, ProfileSensorSettings& settings);

/// Simulates the sensor over a surface of heights.
class ProfileSensor {
 public:
  /// @throws InvalidConfig unless the measuring range begins in front of the sensor
  explicit ProfileSensor(const ProfileSensorSettings& settings);

  /// The points where each ray first meets the surface [mm, sensor frame], in the order of the fan. A ray
  /// that meets no known cell within the range gives no point. The cells of the surface are columns up to
  /// their height, which hide the cells behind them.
  ///
  /// A ray with a second return (`mirror_rate`) gives two points, the nearer one first. Defects have random
  /// numbers of their own, so that they do not change the noise.
  ///
  /// @param highest  height above which the surface has no cells [mm]; shortens the search
  /// @param now_s    time since drift began [s]
  std::vector<Point3> measure(const HeightSource& surface, const Eigen::Isometry3d& bed_from_sensor,
                              double highest = std::numeric_limits<double>::infinity(), double now_s = 0.0);
  std::vector<Point3> measure(const HeightMap& surface, const Eigen::Isometry3d& bed_from_sensor,
                              double highest = std::numeric_limits<double>::infinity(), double now_s = 0.0) {
    return measure(sourceOf(surface), bed_from_sensor, highest, now_s);
  }

  /// Error of the next profile's time stamp: time stamp less true time [s].
  double stampError();

 private:
  double noise();

  ProfileSensorSettings settings_;
  Random random_;
  Random defects_;
  std::optional<double> last_noise_mm_;  ///< noise of the profile's last point
};

}  // namespace lamina
