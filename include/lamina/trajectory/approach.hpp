// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "lamina/base/settings_schema.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/trajectory/timed_path.hpp"

namespace lamina {

/// How a machine moves from its present position to the start of a job.
struct ApproachSettings {
  double lift_mm = 20.0;      ///< lift of the nozzle against its tool axis, at both ends of the motion
  double lift_mm_s = 20.0;    ///< speed of the lift
  double joint_speed = 0.25;  ///< speed of the joints between the lifts, as a share of their greatest speeds
};

/// Adds the keys approach.*.
void describe(SettingsSchema& schema, ApproachSettings& settings);

/// A motion on which nothing is deposited.
struct Approach {
  std::vector<JointValues> stations;  ///< joint positions, between which the joints move in proportion
  std::unique_ptr<TimedPath> motion;  ///< the motion over time; the process is off throughout
};

/// Plans the motion from rest at `from` to rest at `to`: the nozzle is lifted against its tool axis, the
/// joints move in proportion to a position above `to`, and the nozzle is lowered along its tool axis. A lift
/// ends early where a joint reaches its limit, or where the joints cannot follow the nozzle.
/// @throws InvalidConfig naming key, value and bound
/// @throws InvalidInput if `from` and `to` are equal, or not values of the kinematic model's joints
/// @throws Unreachable naming joint, value and limits, if one of them is outside the joints' limits
Approach approach(const JointValues& from, const JointValues& to, const KinematicModel& model,
                  const ApproachSettings& settings, const TimingSettings& timing);

}  // namespace lamina
