// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory_messages.hpp"

#include "conversions.hpp"
#include "joint_messages.hpp"
#include "names.hpp"

namespace lamina {
namespace {

geometry_msgs::Vector3 vectorMessage(const Point3& vector) {
  geometry_msgs::Vector3 message;
  message.x = vector.x();
  message.y = vector.y();
  message.z = vector.z();
  return message;
}

trajectory_msgs::MultiDOFJointTrajectoryPoint pointOf(const NozzleState& state) {
  trajectory_msgs::MultiDOFJointTrajectoryPoint point;
  point.transforms.resize(1);
  point.transforms[0].translation = vectorMessage(kMetresPerMillimetre * state.tip);
  point.transforms[0].rotation = toMessage(state.orientation);
  point.velocities.resize(1);
  point.velocities[0].linear = vectorMessage(kMetresPerMillimetre * state.velocity);
  point.velocities[0].angular = vectorMessage(state.turn);
  return point;
}

}  // namespace

nav_msgs::Path nozzlePath(const Toolpath& toolpath, double spacing_mm) {
  nav_msgs::Path message;
  message.header.frame_id = names::kPartFrame;
  geometry_msgs::PoseStamped pose;
  pose.header = message.header;
  Point3 last = Point3::Zero();
  const auto add = [&](const Path& path, std::size_t waypoint) {
    last = path.points[waypoint];
    pose.pose.position = toMessage(last);
    pose.pose.orientation = toMessage(path.orientation.at(waypoint));
    message.poses.push_back(pose);
  };
  for (const ToolpathLayer& layer : toolpath.layers) {
    for (const Path& path : layer.paths) {
      if (&path == &layer.paths.front()) add(path, 0);
      for (std::size_t m = 0; m < path.motionCount(); ++m) {
        const std::size_t end = path.motionEnd(m);
        const bool is_last = &path == &layer.paths.back() && m + 1 == path.motionCount();
        if (is_last || (path.points[end] - last).norm() >= spacing_mm) add(path, end);
      }
    }
  }
  return message;
}

trajectory_msgs::MultiDOFJointTrajectory nozzleTrajectory(const std::vector<NozzleState>& states) {
  trajectory_msgs::MultiDOFJointTrajectory message;
  message.header.frame_id = names::kBedFrame;
  message.joint_names = {names::kNozzleFrame};
  message.points.reserve(states.size());
  for (const NozzleState& state : states) {
    message.points.push_back(pointOf(state));
    message.points.back().time_from_start = ros::Duration(state.time_s - states.front().time_s);
  }
  return message;
}

lamina_msgs::ProcessTrajectory nozzleProcess(const std::vector<NozzleState>& states) {
  lamina_msgs::ProcessTrajectory message;
  message.valid_for = ros::Duration(states.back().time_s - states.front().time_s);
  message.points.reserve(states.size());
  for (const NozzleState& state : states) {
    message.points.push_back(toMessage(state.process));
    message.points.back().time_from_start = ros::Duration(state.time_s - states.front().time_s);
  }
  return message;
}

}  // namespace lamina
