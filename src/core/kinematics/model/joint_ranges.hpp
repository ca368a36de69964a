// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Limits of a joint, as the search among its values needs them.
struct JointRange {
  bool is_rotary = false;
  bool winds = false;      ///< whether the joint is rotary and can turn on by a whole turn
  double low = 0.0;        ///< [mm, rad]
  double high = 0.0;       ///< [mm, rad]
  double middle = 0.0;     ///< middle of the limits; 0 if there are none
  double max_speed = 0.0;  ///< [mm/s or rad/s]
};

/// Ranges of joints.
/// @throws InvalidInput naming the joint if the greatest speed of one is not positive
std::vector<JointRange> jointRanges(const std::vector<DrivenJoint>& joints);

/// The value equal to the given one but for whole turns that is nearest to the middle of the limits. It is
/// within the limits if any such value is. The value of a joint that slides stays as it is.
/// @param value  [mm or rad]
double nearMiddle(const JointRange& range, double value);

/// Whether a value is within the limits, with a tolerance of 1e-9 mm or rad.
bool isWithin(const JointRange& range, double value);

/// Difference from one value to another [mm or rad]; of a joint that winds by the shorter way.
double stepBetween(const JointRange& range, double from, double to);

/// "12.5 deg".
std::string angleText(double angle_rad);
/// "310 mm".
std::string lengthText(double length_mm);
/// `angleText` or `lengthText`, by the kind of joint.
std::string jointValueText(const JointRange& range, double value);

}  // namespace lamina
