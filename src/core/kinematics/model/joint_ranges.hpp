// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"

namespace lamina {

/// Limits of a joint, for the search among its values.
struct JointRange {
  bool is_rotary = false;
  bool winds = false;      ///< whether the joint is rotary and can turn on by a whole turn
  double low = 0.0;        ///< [mm, rad]
  double high = 0.0;       ///< [mm, rad]
  double middle = 0.0;     ///< middle of the limits; 0 if there are none
  double max_speed = 0.0;  ///< [mm/s or rad/s]
};

constexpr double kLimitTolerance = 1e-9;  ///< mm, rad: rounding of inverse solutions

/// Ranges of joints.
/// @throws InvalidInput naming the joint if the greatest speed of one is not positive
std::vector<JointRange> jointRanges(const std::vector<DrivenJoint>& joints);

/// The value nearest to the middle of the limits among those that differ from the given one by whole turns.
/// It is within the limits if any such value is. Values of linear joints stay unchanged.
/// @param value  [mm or rad]
inline double nearMiddle(const JointRange& range, double value) {
  if (!range.is_rotary) return value;
  const double offset = value - range.middle;
  if (offset > -M_PI && offset <= M_PI) return value;
  return value - 2.0 * M_PI * std::ceil(offset / (2.0 * M_PI) - 0.5);
}

/// Whether a value is within the limits, with a tolerance of 1e-9 mm or rad.
inline bool isWithin(const JointRange& range, double value) {
  return value >= range.low - kLimitTolerance && value <= range.high + kLimitTolerance;
}

/// Difference from one value to another [mm or rad]; for a joint that winds, the shorter rotation.
inline double stepBetween(const JointRange& range, double from, double to) {
  const double step = to - from;
  if (!range.winds || (step > -M_PI && step <= M_PI)) return step;
  return step - 2.0 * M_PI * std::ceil(step / (2.0 * M_PI) - 0.5);
}

/// "12.5 deg".
std::string angleText(double angle_rad);
/// "310 mm".
std::string lengthText(double length_mm);
/// `angleText` or `lengthText`, by the kind of joint.
std::string jointValueText(const JointRange& range, double value);

}  // namespace lamina
