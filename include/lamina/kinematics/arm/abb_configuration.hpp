// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Contents of a RAPID `confdata`: the inverse solution by which an arm reaches a target.
struct AbbConfiguration {
  /// Quarter of a turn in which joint 1 is: 0 from 0 to 90 deg, 1 from 90 to 180 deg, -1 from -90 to 0 deg,
  /// ...
  int cf1 = 0;
  int cf4 = 0;  ///< the same of joint 4
  int cf6 = 0;  ///< the same of joint 6
  /// Sum of 4 if the wrist is behind axis 1, 2 if it is behind the lower arm, and 1 if joint 5 is negative.
  int cfx = 0;
};

/// Whether the kinematic model is a six-axis arm, alone or with external axes. Only such arms have
/// configurations.
bool isSixAxisArm(const KinematicModel& model);

/// Whether the kinematic model is an arm, with any number of axes.
bool isArm(const KinematicModel& model);

/// The configuration of an arm at joint values by ABB's convention: at zero the forearm is level and the
/// wrist straight. A value less than 1e-9 rad below the next quarter counts as in that quarter.
/// @throws InvalidConfig if the kinematic model is no six-axis arm
AbbConfiguration abbConfiguration(const KinematicModel& arm, const JointValues& values);

}  // namespace lamina
