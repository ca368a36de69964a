// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// A word of a five-axis program that stands for a joint.
struct AxisLetter {
  char letter = 0;  ///< of XYZABC
  JointKind kind = JointKind::Linear;
  Eigen::Index joint = 0;
};

/// In the order of XYZABC.
/// @throws InvalidConfig if a joint has no letter, or x, y and z are not among them, linear
std::vector<AxisLetter> axisLetters(const KinematicModel& machine);

/// "X Y Z A C".
std::string toText(const std::vector<AxisLetter>& letters);

}  // namespace lamina
