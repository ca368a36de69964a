// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/base/progress.hpp"
#include "lamina/dynamics/platform_dynamics.hpp"
#include "lamina/dynamics/sliding_mode.hpp"
#include "lamina/dynamics/tracking_reference.hpp"

namespace lamina {

/// Settings of the simulation of a platform under its controller.
struct TrackingSettings {
  PlatformInertia inertia;  ///< as the controller knows it
  /// Additional mass at the platform's centre of mass, unknown to the controller.
  double unknown_load_kg = 0.0;
  SlidingModeGains gains;
  double step_s = 1e-3;  ///< step of the integration, by a Runge-Kutta method of order 4
};

/// Adds the keys platform.*, controller.* and simulation.*.
void describe(SettingsSchema& schema, TrackingSettings& settings);

/// The state of a platform under its controller at a time.
struct TrackingSample {
  double time_s = 0.0;
  CrankAngles error = CrankAngles::Zero();   ///< reference less actual angles of the cranks [rad]
  CrankAngles torque = CrankAngles::Zero();  ///< [N m]
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< base_from_platform [mm]
  double tip_error_mm = 0.0;  ///< distance of the reported point (`tip_mm`) from its reference
  double turn_error = 0.0;    ///< root of the sum of the squared errors of alpha, beta and gamma [rad]
};

/// Errors and effort with which a reference was followed [Guacheta2021, eq. 4.8 to 4.11]. Greatest values are
/// those at the beginnings of steps.
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

/// Simulates a platform that follows a reference, with a controller in continuous time.
class TrackingSimulation {
 public:
  /// Starts at rest, at the first pose of the reference.
  /// @param reference  must outlive the simulation
  /// @param tip_mm     the point whose error is reported, such as the nozzle's tip [platform frame]
  /// @throws InvalidConfig as `requireStable`, or if the step is not positive
  TrackingSimulation(const TrackingReference& reference, const RusPlatform& platform, const Point3& tip_mm,
                     const TrackingSettings& settings);

  /// Starts again at rest, with other angles of the cranks than the first ones of the reference, and with the
  /// integrals at zero.
  /// @throws Unreachable as `poseFromHome`
  void startAt(const CrankAngles& cranks);

  double time() const { return time_s_; }
  double duration() const { return reference_.duration(); }
  bool isFinished() const { return time_s_ >= duration(); }
  /// Advances by a step; the last one is shortened to end with the reference.
  /// @throws Unreachable stating the time if the platform comes to a singularity or out of reach
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
  ReferenceState asked_;  ///< the reference at `time_s_`
  State state_ = State::Zero();
  TrackingFigures report_;
};

/// Simulates a whole reference.
/// @throws Cancelled if `progress` is cancelled; Unreachable as `TrackingSimulation::step`
TrackingFigures simulateTracking(TrackingSimulation simulation, Progress& progress);

}  // namespace lamina
