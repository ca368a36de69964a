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
constexpr double kStillFor = 0.2;          // s
constexpr double kOffLinear = 1.0;         // mm by which a joint at rest may be off what it was sent to
constexpr double kOffRotary = 0.01;        // rad, the same

/// The joint, or the tip, that is farther from a place than a controller at rest leaves it, in words; empty
/// if none is. Whole turns of a rotary joint make no difference.
std::string offPlace(const JointValues& here, const JointValues& place, const KinematicModel& model,
                     double most_tip_mm) {
  const std::vector<DrivenJoint>& joints = model.joints();
  const double tip_mm =
      (model.bedFromNozzle(here).translation() - model.bedFromNozzle(place).translation()).norm();
  std::size_t worst = 0;
  double worst_share = 0.0;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const bool is_linear = joints[j].kind == JointKind::Linear;
    const auto i = static_cast<Eigen::Index>(j);
    const double off = here[i] - place[i];
    const double share =
        is_linear ? std::abs(off) / kOffLinear : std::abs(std::remainder(off, 2.0 * M_PI)) / kOffRotary;
    if (share <= worst_share) continue;
    worst = j;
    worst_share = share;
  }
  if (worst_share <= 1.0 && (most_tip_mm <= 0.0 || tip_mm <= most_tip_mm)) return {};
  const char* const unit = joints[worst].kind == JointKind::Linear ? " mm" : " rad";
  const auto i = static_cast<Eigen::Index>(worst);
  return "joint '" + joints[worst].name + "' is at " + numberText(here[i]) + unit + ", and the nozzle " +
         numberText(tip_mm) + " mm off; expected the joint at " + numberText(place[i]) + unit +
         ", where the motion goes on";
}

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
                     "' that is newer than " + numberText(age_s) + " s; expected all driven joints of " +
                     model_.name() + ", to know where it stands");
    ros::WallDuration(kJointLookPeriod).sleep();
  }
}

std::string PresentJoints::refusalAt(const JointValues& place, double most_tip_mm, double age_s,
                                     const JointWait& wait) const {
  const ros::WallTime begin = ros::WallTime::now();
  for (;;) {
    const bool is_last = (ros::WallTime::now() - begin).toSec() >= wait.longest_s;
    try {
      std::string refusal = offPlace(fresh(age_s, 0.0), place, model_, most_tip_mm);
      if (refusal.empty() || is_last || areStillFor(kStillFor)) return refusal;
    } catch (const TimedOut&) {
      if (is_last) throw;
    }
    if (wait.is_cancelled()) throw Cancelled("cancelled before the joints were known");
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
