// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/toolpath/timing.hpp"
#include "lamina/trajectory/joint_trajectory.hpp"

namespace lamina {

/// The nozzle at one instant over the bed, in the bed's frame, and the process with it.
struct NozzleState {
  double time_s = 0.0;
  Point3 tip = Point3::Zero();                    ///< [mm]
  Eigen::Quaterniond orientation = nozzleDown();  ///< bed_from_nozzle
  Point3 velocity = Point3::Zero();               ///< of the tip [mm/s]
  Point3 turn = Point3::Zero();                   ///< angular velocity [rad/s]
  ProcessSignals process;
};

/// How many states a second a Cartesian trajectory may have [Hz].
inline constexpr Bounds kNozzleRates{50.0, 500.0};

/// Where the joints bring the nozzle, and how fast: what the machine does, corners rounded as they are.
NozzleState nozzleState(const JointState& joints, const KinematicModel& model);

/// A nozzle of a machine that only moves its tip, as a toolpath is played; nothing of the process but flow
/// and levels. Its velocity is along the motion that runs.
/// @param sample  of a player of that toolpath
NozzleState nozzleState(const NozzleSample& sample, const Toolpath& toolpath,
                        const Eigen::Isometry3d& bed_from_part);

/// Instants from one to another at even steps, and the other itself.
/// @param step_s  (0, inf)
std::vector<double> evenTimes(double begin_s, double end_s, double step_s);

/// The same turn by the quaternion that is nearer to another's, of the two that describe it.
Eigen::Quaterniond alignedWith(const Eigen::Quaterniond& turn, const Eigen::Quaterniond& other);

/// The nozzle at these instants, in order, no quaternion the negative of what goes on from the one before.
/// @param state_at  a `NozzleState` of an instant
template <class StateAt>
std::vector<NozzleState> nozzleStates(const std::vector<double>& times_s, StateAt state_at) {
  std::vector<NozzleState> states;
  states.reserve(times_s.size());
  for (const double time_s : times_s) {
    states.push_back(state_at(time_s));
    if (states.size() > 1)
      states.back().orientation =
          alignedWith(states.back().orientation, states[states.size() - 2].orientation);
  }
  return states;
}

}  // namespace lamina
