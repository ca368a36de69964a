// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "goal_tolerances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "conversions.hpp"
#include "lamina/base/number_text.hpp"

namespace lamina {
namespace {

constexpr double kAny = std::numeric_limits<double>::infinity();

/// What a tolerance of a message stands for: 0 the controller's own, a negative one none.
double mostOf(double stated, double own) {
  if (stated == 0.0) return own;
  return stated < 0.0 ? kAny : stated;
}

template <class Tolerances, class Most>
void take(const Tolerances& stated, const KinematicModel& model, std::vector<Most>& all) {
  for (const auto& each : stated) {
    const auto& joints = model.joints();
    const auto found = std::find_if(joints.begin(), joints.end(),
                                    [&](const DrivenJoint& joint) { return joint.name == each.name; });
    if (found == joints.end())
      throw GoalFault(follow::Result::INVALID_JOINTS,
                      "a tolerance is of joint '" + each.name + "', which " + model.name() + " has not");
    if (std::isnan(each.position) || std::isnan(each.velocity))
      throw GoalFault(follow::Result::INVALID_GOAL,
                      "a tolerance of joint '" + each.name +
                          "' is nan; expected a number: 0 for the controller's own, below 0 for none");
    const bool is_linear = found->kind == JointKind::Linear;
    const auto inModel = [&](double si) { return is_linear && si > 0.0 ? toMillimetres(si) : si; };
    Most& most = all[static_cast<std::size_t>(found - joints.begin())];
    most.position = mostOf(inModel(each.position), most.position);
    most.velocity = mostOf(inModel(each.velocity), most.velocity);
  }
}

std::string farText(const std::string& joint, double off, double most, const std::string& where) {
  return "joint '" + joint + "' is " + numberText(off) + " off " + where + "; expected " + numberText(most) +
         " at most";
}

}  // namespace

GoalTolerances::GoalTolerances(const follow::Goal& goal, const KinematicModel& model, double own)
    : path_(model.joints().size(), {own > 0.0 ? own : kAny, kAny}),
      goal_(model.joints().size(), {kAny, kAny}),
      patience_s_(goal.goal_time_tolerance.toSec()) {
  take(goal.path_tolerance, model, path_);
  take(goal.goal_tolerance, model, goal_);
}

std::string GoalTolerances::faultOnTheWay(const Motion& motion, const KinematicModel& model) const {
  for (std::size_t j = 0; j < path_.size(); ++j) {
    const auto i = static_cast<Eigen::Index>(j);
    const double off = std::abs(motion.wanted[i] - motion.position[i]);
    if (off > path_[j].position) return farText(model.joints()[j].name, off, path_[j].position, "its path");
  }
  return "";
}

std::string GoalTolerances::faultAtTheEnd(const Motion& motion, const KinematicModel& model) const {
  for (std::size_t j = 0; j < goal_.size(); ++j) {
    const auto i = static_cast<Eigen::Index>(j);
    const double off = std::abs(motion.wanted[i] - motion.position[i]);
    if (off > goal_[j].position) return farText(model.joints()[j].name, off, goal_[j].position, "its goal");
    const double speed = std::abs(motion.velocity[i]);
    if (speed > goal_[j].velocity)
      return farText(model.joints()[j].name, speed, goal_[j].velocity, "rest at its goal");
  }
  return "";
}

void requireJoints(const std::vector<std::string>& names, const KinematicModel& model) {
  const auto refuse = [](const std::string& why) { throw GoalFault(follow::Result::INVALID_JOINTS, why); };
  for (const DrivenJoint& joint : model.joints())
    if (std::count(names.begin(), names.end(), joint.name) != 1)
      refuse("joint '" + joint.name + "' is named " +
             std::to_string(std::count(names.begin(), names.end(), joint.name)) + " times; expected once");
  if (names.size() != model.joints().size())
    refuse(std::to_string(names.size()) + " joints are named; " + model.name() + " has " +
           std::to_string(model.joints().size()));
}

}  // namespace lamina
