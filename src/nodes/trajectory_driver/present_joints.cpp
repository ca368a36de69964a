// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "present_joints.hpp"

#include <ros/ros.h>

#include <cmath>

#include "conversions.hpp"
#include "lamina/base/error.hpp"
#include "lamina/base/number_text.hpp"
#include "names.hpp"
#include "shutdown.hpp"

namespace lamina {
namespace {

constexpr double kJointLookPeriod = 0.02;  // s of wall time: that of ROS may stand still
constexpr double kStill = 1e-3;            // mm or rad: what encoders of a joint at rest may report

}  // namespace

PresentJoints::PresentJoints(ros::NodeHandle& node, const KinematicModel& model) : model_(model) {
  const boost::function<void(const sensor_msgs::JointStateConstPtr&)> onState = [this](const auto& state) {
    hear(*state);
  };
  subscriber_ = node.subscribe<sensor_msgs::JointState>(names::kJointStates, 100, onState);
}

void PresentJoints::hear(const sensor_msgs::JointState& state) {
  const ros::Time now = ros::Time::now();
  const std::lock_guard<std::mutex> lock(mutex_);
  for (std::size_t i = 0; i < std::min(state.name.size(), state.position.size()); ++i) {
    for (const DrivenJoint& joint : model_.joints()) {
      if (joint.name != state.name[i] || !std::isfinite(state.position[i])) continue;
      Heard& heard = heard_[joint.name];
      heard.value = joint.kind == JointKind::Linear ? toMillimetres(state.position[i]) : state.position[i];
      // Of a time to come, as before ROS time went back, nothing can be said.
      if (heard.at.isZero() || heard.at > now || std::abs(heard.value - heard.mark) > kStill) {
        heard.mark = heard.value;
        heard.moved_at = now;
      }
      heard.at = now;
    }
  }
}

std::string PresentJoints::missingWithin(double age_s, const ros::Time& now) const {
  for (const DrivenJoint& joint : model_.joints()) {
    const auto found = heard_.find(joint.name);
    if (found == heard_.end() || std::abs((now - found->second.at).toSec()) > age_s) return joint.name;
  }
  return "";
}

JointValues PresentJoints::fresh(double age_s, double wait_s) const {
  const ros::Time begin = ros::Time::now();
  for (;;) {
    const ros::Time now = ros::Time::now();
    std::string missing;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      missing = missingWithin(age_s, now);
      if (missing.empty()) {
        JointValues values(static_cast<Eigen::Index>(model_.joints().size()));
        for (Eigen::Index j = 0; j < values.size(); ++j)
          values[j] = heard_.at(model_.joints()[static_cast<std::size_t>(j)].name).value;
        return values;
      }
    }
    if (isStopRequested() || !ros::ok()) throw Cancelled("the node was ended");
    if ((now - begin).toSec() >= wait_s)
      throw TimedOut("'" + std::string(names::kJointStates) + "' reports nothing of joint '" + missing +
                     "' in " + numberText(wait_s) + " s; expected all driven joints of " + model_.name() +
                     ", to know where it stands");
    ros::WallDuration(kJointLookPeriod).sleep();
  }
}

bool PresentJoints::areStillFor(double time_s) const {
  const ros::Time now = ros::Time::now();
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& [name, heard] : heard_)
    if ((now - heard.moved_at).toSec() < time_s || (now - heard.at).toSec() > time_s) return false;
  return true;
}

}  // namespace lamina
