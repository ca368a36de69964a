// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program/five_axis/five_axis_lines.hpp"

#include <algorithm>
#include <cmath>

#include "program/gcode/fixed_point.hpp"

namespace lamina {
namespace {

constexpr double kLinearScale = 1e4;                 // 4 decimals
constexpr double kRotaryScale = 1e5 * 180.0 / M_PI;  // 5 decimals of a degree
constexpr double kFilamentScale = 1e5;
constexpr std::size_t kLinear = 3;

template <int decimals>
std::string fixed(char letter, std::int64_t units) {
  char digits[32];
  return std::string(" ") + letter + std::string(digits, writeFixed<decimals>(digits, units));
}

}  // namespace

FiveAxisLines::FiveAxisLines(const KinematicModel& machine, const FiveAxisSettings& settings,
                             const ProgramSettings& program)
    : machine_(machine),
      letters_(axisLetters(machine)),
      has_joints_(settings.coordinates == FiveAxisCoordinates::Joints),
      retraction_feed_mm_s_(program.retraction_feed_mm_s),
      axes_(letters_.size(), kUnknown) {}

std::int64_t FiveAxisLines::unitsOf(std::size_t axis, const JointValues& joints, const Point3& tip) const {
  if (axis >= kLinear) return toUnits(joints[letters_[axis].joint], kRotaryScale);
  const double value = has_joints_ ? joints[letters_[axis].joint] : tip[static_cast<Eigen::Index>(axis)];
  return toUnits(value, kLinearScale);
}

std::string FiveAxisLines::word(std::size_t axis, std::int64_t units) const {
  return axis < kLinear ? fixed<4>(letters_[axis].letter, units) : fixed<5>(letters_[axis].letter, units);
}

std::string FiveAxisLines::changes(std::size_t begin, std::size_t end, const JointValues& joints,
                                   const Point3& tip) {
  std::string words;
  for (std::size_t axis = begin; axis < end; ++axis) {
    const std::int64_t units = unitsOf(axis, joints, tip);
    if (units == axes_[axis]) continue;
    axes_[axis] = units;
    words += word(axis, units);
  }
  return words;
}

std::string FiveAxisLines::feedWord(double per_minute) {
  if (has_joints_) return fixed<5>('F', std::max<std::int64_t>(1, toUnits(per_minute, 1e5)));
  const std::int64_t units = std::max<std::int64_t>(1, toUnits(per_minute, 1e3));
  if (units == feed_) return "";
  feed_ = units;
  return fixed<3>('F', units);
}

void FiveAxisLines::approach(const JointValues& joints, const Point3& tip, const std::string& tip_control,
                             std::string& text) {
  if (letters_.size() > kLinear) text += "G0" + changes(kLinear, letters_.size(), joints, tip) + "\n";
  if (!tip_control.empty()) text += tip_control + "\n";
  text += "G0" + changes(0, 2, joints, tip) + "\n";
  text += "G0" + changes(2, kLinear, joints, tip) + "\n";
  joints_ = joints;
  tip_ = tip;
}

void FiveAxisLines::move(const FiveAxisTarget& target, std::string& text) {
  filament_mm_ += target.filament_mm;
  waiting_s_ += target.time_s;
  const std::int64_t filament = toUnits(filament_mm_, kFilamentScale);
  // Too little to be written: without E it would read as a travel. The next motion takes it along.
  if (target.filament_mm > 0.0 && filament == filament_) return;
  std::string words = changes(0, letters_.size(), target.joints, target.tip);
  if (words.empty()) return;
  if (filament != filament_) words += fixed<5>('E', filament - filament_);
  filament_ = filament;
  words += feedWord(has_joints_ ? 60.0 / waiting_s_ : 60.0 * target.feed);
  text.append("G1").append(words).append(target.remark).append("\n");
  waiting_s_ = 0.0;
  joints_ = target.joints;
  tip_ = target.tip;
}

void FiveAxisLines::turn(const JointValues& joints, std::string& text) {
  double time_s = 0.0;
  double square_deg = 0.0;
  bool has_changed = false;
  for (std::size_t axis = 0; axis < letters_.size(); ++axis) {
    const AxisLetter& letter = letters_[axis];
    const double way = std::abs(joints[letter.joint] - joints_[letter.joint]);
    const double speed = machine_.joints()[static_cast<std::size_t>(letter.joint)].max_speed;
    time_s = std::max(time_s, way / speed);
    if (axis >= kLinear) square_deg += way * way * (180.0 / M_PI) * (180.0 / M_PI);
    // The same tip comes of other linear joints where rotary ones turn.
    has_changed |= axis >= kLinear && unitsOf(axis, joints, tip_) != axes_[axis];
  }
  if (!has_changed || !(time_s > 0.0)) return;
  FiveAxisTarget target;
  target.joints = joints;
  target.tip = tip_;
  target.remark = " ;turn";
  target.time_s = time_s;
  target.feed = std::sqrt(square_deg) / time_s;
  move(target, text);
}

void FiveAxisLines::retract(double length_mm, std::string& text) {
  const std::int64_t units = toUnits(length_mm, kFilamentScale);
  if (units == 0) return;
  const double feed = retraction_feed_mm_s_;
  text += "G1" + fixed<5>('E', units) +
          feedWord(has_joints_ ? 60.0 * feed / std::abs(length_mm) : 60.0 * feed) + "\n";
}

void FiveAxisLines::comment(const char* key, double value, std::string& text) {
  char digits[32];
  text.append(key).append(digits, writeFixed<5>(digits, toUnits(value, 1e5))).append("\n");
}

}  // namespace lamina
