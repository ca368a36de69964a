// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// What searching among the values of a joint needs to know of it.
struct JointRange {
  bool is_rotary = false;
  bool winds = false;   ///< it is rotary and can go on by a whole turn
  double low = 0.0;     ///< [mm, rad]
  double high = 0.0;    ///< [mm, rad]
  double middle = 0.0;  ///< of the limits; 0 if it has none
  double max_speed = 0.0;
};

/// @throws InvalidInput if a joint's greatest speed is not positive, naming it
std::vector<JointRange> jointRanges(const std::vector<DrivenJoint>& joints);

/// The value of the joint that is the same but for whole turns, next to the middle of its limits: where the
/// limits let any of them in, they let this one in.
double nearMiddle(const JointRange& range, double value);

/// Whether the limits let the value in, but for 1e-9 mm or rad.
bool isWithin(const JointRange& range, double value);

/// From one value to another: of a joint that winds the shorter way round.
double stepBetween(const JointRange& range, double from, double to);

/// "12.5 deg".
std::string angleText(double angle_rad);
/// "310 mm".
std::string lengthText(double length_mm);
/// One of both, as the joint is.
std::string jointValueText(const JointRange& range, double value);

}  // namespace lamina
