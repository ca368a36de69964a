// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/trajectory/timed_path.hpp"

namespace lamina {

/// How a machine comes from where it stands to where a job begins.
struct ApproachSettings {
  double lift_mm = 20.0;      ///< of the nozzle against its tool axis, at both ends of the way
  double lift_mm_s = 20.0;    ///< speed of that
  double joint_speed = 0.25;  ///< of the joints in between, of their greatest speeds
};

/// Adds the keys approach.*.
void describe(SettingsSchema& schema, ApproachSettings& settings);

/// A way of the joints on which nothing is deposited.
struct Approach {
  std::vector<JointValues> stations;  ///< between which the joints go in proportion
  std::unique_ptr<TimedPath> motion;  ///< the process is off all the time
};

/// The way from rest at `from` to rest at `to`: the nozzle is lifted against its tool axis, the joints go
/// steadily to above `to`, and the nozzle comes down along its tool axis. Where a lift cannot be followed, or
/// a joint's limits end it, it ends there.
/// @throws InvalidConfig naming key, value and bound
/// @throws InvalidInput if `from` and `to` are the same, or not values of the kinematic model's joints
/// @throws Unreachable if one of them is outside the joints' limits, naming joint, value and limits
Approach approach(const JointValues& from, const JointValues& to, const KinematicModel& model,
                  const ApproachSettings& settings, const TimingSettings& timing);

}  // namespace lamina
