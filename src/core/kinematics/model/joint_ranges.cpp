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

constexpr int kDigits = 4;

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
    range.winds = range.is_rotary && joint.high - joint.low >= 2.0 * M_PI - kLimitTolerance;
    const double middle = 0.5 * (joint.low + joint.high);
    range.middle = std::isfinite(middle) ? middle : 0.0;
    range.max_speed = joint.max_speed;
    ranges.push_back(range);
  }
  return ranges;
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
