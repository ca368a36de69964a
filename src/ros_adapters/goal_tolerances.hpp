// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "follow_joint_trajectory.hpp"
#include "lamina/base/error.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// A goal that is refused or given up, with the action's code for it.
class GoalFault final : public InvalidInput {
 public:
  GoalFault(std::int32_t code, const std::string& message) : InvalidInput(message), code_(code) {}
  std::int32_t code() const { return code_; }

 private:
  std::int32_t code_;
};

/// How far joints may be from where a goal wants them, on the way and at its end.
class GoalTolerances {
 public:
  GoalTolerances() = default;
  /// @param own  of the controller for positions on the way, of goals that state none; 0 for any [mm, rad]
  /// @throws GoalFault as INVALID_JOINTS, naming a joint that the model has not
  GoalTolerances(const follow::Goal& goal, const KinematicModel& model, double own);

  /// What is asked of joints and what they do.
  struct Motion {
    const JointValues& wanted;
    const JointValues& position;
    const JointValues& velocity;
  };
  /// The joint that is too far off on the way, in words; empty if there is none.
  std::string faultOnTheWay(const Motion& motion, const KinematicModel& model) const;
  /// The same at the end, where a joint that is to rest also may still be too fast.
  std::string faultAtTheEnd(const Motion& motion, const KinematicModel& model) const;
  /// How long after the goal's time joints may still come to its end [s].
  double patience() const { return patience_s_; }

 private:
  /// Of a joint; infinite where none is asked.
  struct Most {
    double position;
    double velocity;
  };
  std::vector<Most> path_;
  std::vector<Most> goal_;
  double patience_s_ = 0.0;
};

/// @throws GoalFault as INVALID_JOINTS, naming a joint that is missing, unknown or named twice
void requireJoints(const std::vector<std::string>& names, const KinematicModel& model);

}  // namespace lamina
