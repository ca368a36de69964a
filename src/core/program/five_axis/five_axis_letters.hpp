// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/program/five_axis/five_axis_settings.hpp"

namespace lamina {

/// Beginning of the comment that names the axes whose words stand within one turn.
constexpr std::string_view kModuloMark = ";MODULO:";

/// A letter of a five-axis program, and the joint for which it stands.
struct AxisLetter {
  char letter = 0;  ///< of XYZABCUVW
  JointKind kind = JointKind::Linear;
  Eigen::Index joint = 0;
};

/// The letters of a machine's joints, in the order of XYZABCUVW.
/// @param renamed  `five_axis.letters`: "b=U,c=V" for rotary joints that have other letters than their names
/// @throws InvalidConfig if a joint has no letter or the letter of another, if x, y or z is missing as a
///   linear joint, or if a renamed joint is not rotary or its letter is not one of ABCUVW
std::vector<AxisLetter> axisLetters(const KinematicModel& machine, const std::string& renamed);

/// The letters whose words stand within one turn: none if turns are counted, otherwise the letters of rotary
/// joints without limits.
/// @throws InvalidConfig if the dialect knows no such words
std::vector<AxisLetter> moduloLetters(const KinematicModel& machine, const FiveAxisSettings& settings);

/// The letters separated by spaces: "X Y Z A C".
std::string toText(const std::vector<AxisLetter>& letters);

}  // namespace lamina
