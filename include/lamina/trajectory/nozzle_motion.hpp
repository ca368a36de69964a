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

/// The state of nozzle and process at one instant, in the bed frame.
struct NozzleState {
  double time_s = 0.0;
  Point3 tip = Point3::Zero();                    ///< [mm]
  Eigen::Quaterniond orientation = nozzleDown();  ///< bed_from_nozzle
  Point3 velocity = Point3::Zero();               ///< of the tip [mm/s]
  Point3 turn = Point3::Zero();                   ///< angular velocity [rad/s]
  ProcessSignals process;
};

/// Bounds of the number of states per second of a Cartesian trajectory [Hz].
inline constexpr Bounds kNozzleRates{50.0, 500.0};

/// The state of the nozzle, computed from the state of the joints: with corners as the machine rounds them.
NozzleState nozzleState(const JointState& joints, const KinematicModel& model);

/// The state of the nozzle on a machine with linear axes while a toolpath is played. Of the process, only
/// flow and levels are set. The angular velocity is 0, the velocity along the running motion.
/// @param sample  from a player of that toolpath
NozzleState nozzleState(const NozzleSample& sample, const Toolpath& toolpath,
                        const Eigen::Isometry3d& bed_from_part);

/// The times begin_s, begin_s + step_s, ... before end_s, and end_s itself.
/// @param step_s  positive and finite
std::vector<double> evenTimes(double begin_s, double end_s, double step_s);

/// Of a rotation's two quaternions, the one nearer to another quaternion.
Eigen::Quaterniond alignedWith(const Eigen::Quaterniond& turn, const Eigen::Quaterniond& other);

/// The states of the nozzle at these times, in order, with signs of the quaternions that make them
/// continuous.
/// @param state_at  function that returns the `NozzleState` at a time
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
