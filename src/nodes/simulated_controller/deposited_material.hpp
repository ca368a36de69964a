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

/// Where the nozzle is at an instant, and what flows from it.
struct NozzleInstant {
  double time_s = 0.0;
  Point3 tip = Point3::Zero();  ///< [mm, bed]
  double asked_mm3_s = 0.0;     ///< flow that the feeder is asked for
};

/// What a simulated machine has deposited on a part of its bed, and what its profile sensor sees of it. The
/// process is that of the emulated machine: the same beads grow to the same heights.
class DepositedMaterial {
 public:
  /// @throws InvalidConfig if the area is none, or has more cells than a map can have
  explicit DepositedMaterial(const ControllerSettings& settings);

  /// Lays what flows from the instant before to this one, straight from tip to tip. The first one lays
  /// nothing.
  void observe(const NozzleInstant& now);

  /// What the sensor sees [mm, sensor frame].
  std::vector<Point3> seenFrom(const Eigen::Isometry3d& bed_from_sensor, double now_s);
  /// By how much the next stamp is later than the time of what it is of [s].
  double stampError() { return sensor_.stampError(); }

  const HeightMap& surface() const { return deposit_.surface(); }

 private:
  GrownDeposit deposit_;
  ProfileSensor sensor_;
  std::optional<NozzleInstant> last_;
};

}  // namespace lamina
