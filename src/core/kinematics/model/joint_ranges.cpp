// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kinematics/model/joint_ranges.hpp"

#include <cmath>
#include <sstream>

#include "lamina/base/angle.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {

namespace {

constexpr double kTurn = 2.0 * M_PI;
constexpr int kDigits = 4;
constexpr double kLimitTolerance = 1e-9;  // mm, rad: rounding of inverse solutions

}  // namespace

std::vector<JointRange> jointRanges(const std::vector<DrivenJoint>& joints) {
  std::vector<JointRange> ranges;
  ranges.reserve(joints.size());
  for (const DrivenJoint& joint : joints) {
    if (!(joint.max_speed > 0.0))
      throw InvalidInput("greatest speed of joint " + joint.name + " is " + numberText(joint.max_speed) +
                         "; must be positive");
    JointRange range;
    range.is_rotary = joint.kind == JointKind::Rotary;
    range.low = joint.low;
    range.high = joint.high;
    range.winds = range.is_rotary && joint.high - joint.low >= kTurn - kLimitTolerance;
    const double middle = 0.5 * (joint.low + joint.high);
    range.middle = std::isfinite(middle) ? middle : 0.0;
    range.max_speed = joint.max_speed;
    ranges.push_back(range);
  }
  return ranges;
}

double nearMiddle(const JointRange& range, double value) {
  if (!range.is_rotary) return value;
  const double offset = value - range.middle;
  if (offset > -M_PI && offset <= M_PI) return value;
  return value - kTurn * std::ceil(offset / kTurn - 0.5);
}

bool isWithin(const JointRange& range, double value) {
  return value >= range.low - kLimitTolerance && value <= range.high + kLimitTolerance;
}

double stepBetween(const JointRange& range, double from, double to) {
  const double step = to - from;
  if (!range.winds || (step > -M_PI && step <= M_PI)) return step;
  return step - kTurn * std::ceil(step / kTurn - 0.5);
}

std::string angleText(double angle_rad) {
  std::ostringstream text;
  text.precision(kDigits);
  text << toDegrees(angle_rad) << " deg";
  return text.str();
}

std::string lengthText(double length_mm) {
  std::ostringstream text;
  text.precision(kDigits);
  text << length_mm << " mm";
  return text.str();
}

std::string jointValueText(const JointRange& range, double value) {
  return range.is_rotary ? angleText(value) : lengthText(value);
}

}  // namespace lamina
