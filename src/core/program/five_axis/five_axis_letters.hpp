// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// A word of a five-axis program that stands for a joint.
struct AxisLetter {
  char letter = 0;  ///< of XYZABCUVW
  JointKind kind = JointKind::Linear;
  Eigen::Index joint = 0;
};

/// In the order of XYZABCUVW.
/// @param renamed  `five_axis.letters`: "b=U,c=V" for rotary joints that programs name otherwise
/// @throws InvalidConfig if a joint has no letter or that of another, if x, y and z are not among them,
/// linear,
///   or if what is renamed is no rotary joint, or to no letter of ABCUVW
std::vector<AxisLetter> axisLetters(const KinematicModel& machine, const std::string& renamed);

/// "X Y Z A C".
std::string toText(const std::vector<AxisLetter>& letters);

}  // namespace lamina
