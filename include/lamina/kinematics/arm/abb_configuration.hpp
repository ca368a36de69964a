// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// What a RAPID `confdata` holds: which of the ways to a target an arm takes.
struct AbbConfiguration {
  int cf1 =
      0;  ///< quarter turn of joint 1: 0 from 0 to 90 deg, 1 from 90 to 180 deg, -1 from -90 to 0 deg, ...
  int cf4 = 0;  ///< of joint 4
  int cf6 = 0;  ///< of joint 6
  /// 4 if the wrist is behind axis 1, plus 2 if it is behind the lower arm, plus 1 if joint 5 is negative.
  int cfx = 0;
};

/// Whether the kinematic model is a six-axis arm, alone or with external axes: only these have
/// configurations.
bool isSixAxisArm(const KinematicModel& model);

/// The configuration of an arm whose joints count as those of ABB: at zero the forearm is level and the wrist
/// straight. A value less than 1e-9 rad below a quarter turn counts as that.
/// @throws InvalidConfig if the kinematic model is no six-axis arm
AbbConfiguration abbConfiguration(const KinematicModel& arm, const JointValues& values);

}  // namespace lamina
