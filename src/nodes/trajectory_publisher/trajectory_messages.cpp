// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "trajectory_messages.hpp"

#include "conversions.hpp"
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

}  // namespace lamina
