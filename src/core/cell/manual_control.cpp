// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "lamina/cell/manual_control.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "lamina/base/number_text.hpp"
#include "lamina/base/text.hpp"

namespace lamina {
namespace {

constexpr std::array<std::string_view, 4> kTipFrames = {"nozzle", "part", "bed", "base_link"};
constexpr std::array<std::string_view, 6> kTipAxes = {"x", "y", "z", "rx", "ry", "rz"};
constexpr double kRounding = 1e-9;  // s

template <class Names>
bool isAmong(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The reason for which nobody may move the machine by hand now.
CommandAnswer againstManual(const ManualConditions& found) {
  if (found.mode != kManual)
    return {CommandResult::NotInThisMode, "the mode is " + std::to_string(found.mode) +
                                              "; expected 3 (Manual) to move the machine by hand"};
  if (found.state != UnitState::Stopped && found.state != UnitState::Idle)
    return {CommandResult::NotInThisState, std::string("the unit is in ") + toString(found.state) +
                                               "; expected Stopped or Idle to move the machine by hand"};
  if (found.is_emergency_stopped)
    return {CommandResult::GuardFailed,
            "the PLC has reported the emergency stop pressed; expected it released, and alarm 1207 "
            "acknowledged, to move the machine by hand"};
  if (!found.zone_fault.empty())
    return {CommandResult::GuardFailed, "the machine is not moved by hand: " + found.zone_fault};
  if (!found.has_driver)
    return {CommandResult::GuardFailed,
            "no node that jogs is heard on jog_state; expected trajectory_driver (G-code machines are moved "
            "at their own panels)"};
  return {};
}

CommandAnswer againstAxis(const ManualStep& step, const std::vector<std::string>& joints) {
  if (step.frame == "joints") {
    if (isAmong(joints, step.axis)) return {};
    return {CommandResult::BadValue,
            "there is no joint '" + step.axis + "'; expected one of " + listed(joints, ", ")};
  }
  if (!isAmong(kTipFrames, step.frame))
    return {CommandResult::BadValue,
            "frame is '" + step.frame + "'; expected joints, nozzle, part, bed or base_link"};
  if (!isAmong(kTipAxes, step.axis))
    return {CommandResult::BadValue, "axis is '" + step.axis + "'; expected x, y, z, rx, ry or rz"};
  return {};
}

CommandAnswer againstStep(const ManualStep& step, const std::vector<std::string>& joints) {
  CommandAnswer answer = againstAxis(step, joints);
  if (answer.result != CommandResult::Accepted) return answer;
  if (!std::isfinite(step.step) || step.step == 0.0)
    return {CommandResult::BadValue,
            "step is " + numberText(step.step) + " m or rad; expected a number other than 0"};
  if (!std::isfinite(step.speed) || step.speed <= 0.0)
    return {CommandResult::BadValue,
            "speed is " + numberText(step.speed) + " m/s or rad/s; expected more than 0"};
  const double time_s = std::abs(step.step) / step.speed;
  if (time_s > kLongestManualStep + kRounding)
    return {CommandResult::BadValue, "the step takes " + numberText(time_s) + " s; expected at most " +
                                         numberText(kLongestManualStep) +
                                         " s, and the step repeated to go farther"};
  return {};
}

}  // namespace

CommandAnswer ManualControl::take(const ManualCaller& who, const ManualConditions& found, CellTime now) {
  CommandAnswer answer = againstManual(found);
  if (answer.result != CommandResult::Accepted) return answer;
  const double left_s = left(now.steady_s);
  if (left_s > 0.0 && !isHeldBy(who, now.steady_s))
    return {CommandResult::Busy, "'" + holder_ +
                                     "' moves the machine by hand; expected its lease released, or " +
                                     numberText(left_s) + " s without use of it"};
  if (!isHeldBy(who, now.steady_s)) {
    end();
    // By the clock, so that a lease from before a restart is none after it.
    number_ = std::max(number_ + 1, static_cast<std::uint64_t>(std::max(0.0, now.utc_s) * 1000.0));
    holder_ = who.source;
  }
  until_s_ = now.steady_s + kManualLease;
  return {};
}

CommandAnswer ManualControl::jog(const ManualCaller& who, const ManualStep& step,
                                 const ManualConditions& found, CellTime now) {
  CommandAnswer answer = againstManual(found);
  if (answer.result == CommandResult::Accepted) answer = againstHolder(who, now.steady_s);
  if (answer.result == CommandResult::Accepted) answer = againstStep(step, found.joints);
  if (answer.result != CommandResult::Accepted) return answer;
  until_s_ = now.steady_s + kManualLease;
  motion_ = step;
  motion_until_s_ = now.steady_s + std::abs(step.step) / step.speed;
  return answer;
}

CommandAnswer ManualControl::release(const ManualCaller& who, CellTime now) {
  CommandAnswer answer = againstHolder(who, now.steady_s);
  if (answer.result == CommandResult::Accepted) end();
  return answer;
}

std::string ManualControl::follow(const ManualConditions& found, CellTime now) {
  if (now.steady_s >= motion_until_s_) motion_.reset();
  if (holder_.empty()) return "";
  std::string reason = againstManual(found).reason;
  if (reason.empty() && left(now.steady_s) == 0.0)
    reason = "the lease was not used for " + numberText(kManualLease) + " s";
  if (!reason.empty()) end();
  return reason;
}

double ManualControl::left(double now_s) const {
  return holder_.empty() ? 0.0 : std::max(0.0, until_s_ - now_s);
}

bool ManualControl::isHeldBy(const ManualCaller& who, double now_s) const {
  return left(now_s) > 0.0 && who.source == holder_ && who.lease == number_;
}

CommandAnswer ManualControl::againstHolder(const ManualCaller& who, double now_s) const {
  if (isHeldBy(who, now_s)) return {};
  const std::string present = left(now_s) > 0.0 ? "'" + holder_ + "' has it" : std::string("nobody has it");
  return {CommandResult::GuardFailed, "'" + who.source + "' shows lease " + std::to_string(who.lease) +
                                          ", which is not the present one (" + present +
                                          "); expected it to be taken first"};
}

void ManualControl::end() {
  holder_.clear();
  motion_.reset();
}

}  // namespace lamina
