// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/progress.hpp"
#include "lamina/dynamics/platform_dynamics.hpp"
#include "lamina/dynamics/sliding_mode.hpp"
#include "lamina/dynamics/tracking_reference.hpp"

namespace lamina {

/// How a platform under its controller is simulated.
struct TrackingSettings {
  PlatformInertia inertia;       ///< what the controller computes with
  double unknown_load_kg = 0.0;  ///< further load on its centre of mass, not known to it
  SlidingModeGains gains;
  double step_s = 1e-3;  ///< of the integration, a Runge-Kutta of order 4
};

/// Adds the keys platform.*, controller.* and simulation.*.
void describe(SettingsSchema& schema, TrackingSettings& settings);

/// A platform under its controller at one instant.
struct TrackingSample {
  double time_s = 0.0;
  CrankAngles error = CrankAngles::Zero();                 ///< of the cranks: reference less actual [rad]
  CrankAngles torque = CrankAngles::Zero();                ///< [N m]
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< base_from_platform [mm]
  double tip_error_mm = 0.0;  ///< of the point that the reference's poses are followed at
  double turn_error = 0.0;    ///< root of the squares of the errors of alpha, beta and gamma [rad]
};

/// What following a reference took [Guacheta2021, eq. 4.8 to 4.11].
struct TrackingFigures {
  double duration_s = 0.0;
  double linear_ise_mm2_s = 0.0;       ///< integral of the squared error of the tip
  double rotational_ise_rad2_s = 0.0;  ///< integral of the squared errors of alpha, beta and gamma
  double control_energy_nm2_s = 0.0;   ///< integral of the squared torques, summed over the cranks
  double greatest_torque_nm = 0.0;
  double greatest_tip_error_mm = 0.0;
  double greatest_turn_error_rad = 0.0;
  double greatest_crank_error_rad = 0.0;
};

/// Simulates a platform that follows a reference, in continuous time.
class TrackingSimulation {
 public:
  /// Starts at rest.
  /// @param tip_mm     the point whose error is reported, such as the nozzle's tip [platform frame]
  /// @param reference  must outlive the simulation
  /// @throws InvalidConfig as `requireStable`, or if the step is not positive
  TrackingSimulation(const TrackingReference& reference, const RusPlatform& platform, const Point3& tip_mm,
                     const TrackingSettings& settings);

  /// Starts at rest, with these angles of the cranks instead of the reference's first ones, and with the
  /// integrals at zero.
  /// @throws Unreachable as `poseFromHome`
  void startAt(const CrankAngles& cranks);

  double time() const { return time_s_; }
  double duration() const { return reference_.duration(); }
  bool isFinished() const { return time_s_ >= duration(); }
  /// One step on; the last one is as short as it has to be.
  /// @throws Unreachable if the platform runs into a singularity or out of reach, giving the time
  void step();
  TrackingSample sample() const;
  const TrackingFigures& report() const { return report_; }

 private:
  /// Position and attitude, twist, integral and double integral of the errors, and the report's integrals.
  using State = Eigen::Matrix<double, 28, 1>;
  struct Slope;
  Slope slopeAt(const State& state, const ReferenceState& reference) const;
  PlatformState platformAt(const State& state) const;

  const TrackingReference& reference_;
  RusPlatform platform_;
  MetricPlatform metric_;
  Point3 tip_mm_;
  TrackingSettings settings_;
  PlatformInertia loaded_;
  double time_s_ = 0.0;
  ReferenceState asked_;  ///< the reference now
  State state_ = State::Zero();
  TrackingFigures report_;
};

/// Simulates the whole of a reference.
/// @throws Cancelled; Unreachable, InvalidConfig as above
TrackingFigures simulateTracking(TrackingSimulation simulation, Progress& progress);

}  // namespace lamina
