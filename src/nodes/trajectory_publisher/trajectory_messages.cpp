// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory_messages.hpp"

#include <algorithm>

#include "names.hpp"

namespace lamina {

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

trajectory_msgs::JointTrajectory jointTrajectory(const Machine& machine,
                                                 const Eigen::Isometry3d& bed_from_part,
                                                 ToolpathPlayer& player, const TimeSpan& span,
                                                 double step_s) {
  trajectory_msgs::JointTrajectory message;
  for (const MachineAxis& axis : machine.axes) message.joint_names.push_back(axis.name);
  for (std::size_t i = 0;; ++i) {
    const double time_s = std::min(span.end_s, span.begin_s + static_cast<double>(i) * step_s);
    trajectory_msgs::JointTrajectoryPoint point;
    point.positions =
        jointState(machine, axisValues(machine, bed_from_part * player.at(time_s).position)).position;
    point.time_from_start = ros::Duration(time_s - span.begin_s);
    message.points.push_back(point);
    if (time_s >= span.end_s) return message;
  }
}

}  // namespace lamina
