// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "controller_settings.hpp"
#include "lamina/deposition/grown_deposit.hpp"
#include "lamina/monitoring/profile_sensor.hpp"

namespace lamina {

/// Position and flow of the nozzle at an instant.
struct NozzleInstant {
  double time_s = 0.0;
  Point3 tip = Point3::Zero();  ///< [mm, bed]
  double asked_mm3_s = 0.0;     ///< flow requested from the feeder
};

/// The deposit of a simulated machine on an area of its bed, and its profile sensor. The process is that of
/// the emulated machine: the same beads grow to the same heights.
class DepositedMaterial {
 public:
  /// @throws InvalidConfig if the area is invalid, or has more cells than a map can have
  explicit DepositedMaterial(const ControllerSettings& settings);

  /// Deposits the flow between the previous instant and this one, straight from tip to tip. The first call
  /// deposits nothing.
  void observe(const NozzleInstant& now);

  /// The points that the sensor measures [mm, sensor frame].
  std::vector<Point3> seenFrom(const Eigen::Isometry3d& bed_from_sensor, double now_s);
  /// Delay of the next stamp against the time of measurement [s].
  double stampError() { return sensor_.stampError(); }

  const HeightMap& surface() const { return deposit_.surface(); }

 private:
  GrownDeposit deposit_;
  ProfileSensor sensor_;
  std::optional<NozzleInstant> last_;
};

}  // namespace lamina
