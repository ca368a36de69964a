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

/// A fault by which a goal is refused or given up, with the action's error code.
class GoalFault final : public InvalidInput {
 public:
  GoalFault(std::int32_t code, const std::string& message) : InvalidInput(message), code_(code) {}
  std::int32_t code() const { return code_; }

 private:
  std::int32_t code_;
};

/// Tolerances of a goal: allowed deviations of joints during the motion and at the end.
class GoalTolerances {
 public:
  GoalTolerances() = default;
  /// @param own  the controller's tolerance during the motion for goals that state none; 0 for no limit [mm,
  ///   rad]
  /// @throws GoalFault as INVALID_JOINTS, naming a joint that the model does not have
  GoalTolerances(const follow::Goal& goal, const KinematicModel& model, double own);

  /// Requested and actual state of the joints.
  struct Motion {
    const JointValues& wanted;
    const JointValues& position;
    const JointValues& velocity;
  };
  /// The joint that deviates too much during the motion, in words; empty if there is none.
  std::string faultOnTheWay(const Motion& motion, const KinematicModel& model) const;
  /// The joint that deviates too much at the end, or should rest and is still too fast, in words; empty if
  /// there is none.
  std::string faultAtTheEnd(const Motion& motion, const KinematicModel& model) const;
  /// Time after the goal's end within which joints may still reach it [s].
  double patience() const { return patience_s_; }

 private:
  /// Tolerance of a joint; infinite if there is none.
  struct Most {
    double position;
    double velocity;
  };
  std::vector<Most> path_;
  std::vector<Most> goal_;
  double patience_s_ = 0.0;
};

/// Refuses names that are not exactly those of the model's joints.
/// @throws GoalFault as INVALID_JOINTS, naming a joint that is missing, unknown or named twice
void requireJoints(const std::vector<std::string>& names, const KinematicModel& model);

}  // namespace lamina
