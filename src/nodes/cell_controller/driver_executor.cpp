// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "driver_executor.hpp"

#include <utility>

#include "driver_language.hpp"
#include "names.hpp"

namespace lamina {

DriverExecutor::DriverExecutor(const ros::NodeHandle& node, Placement placement,
                               std::function<void(const ExecutorReport&)> report)
    : ActionExecutor(node, names::kDriveToolpath, driverLanguage(), std::move(report)),
      placement_(placement) {}

ExecutorTraits DriverExecutor::traits() const {
  return {"waypoint", "trajectory_driver resumes no job that was cut off; discard it"};
}

lamina_msgs::DriveToolpathGoal DriverExecutor::goalOf(const StartOrder& order) const {
  lamina_msgs::DriveToolpathGoal goal;
  goal.program = order.program;
  goal.placement = placement_ == Placement::AsIs ? "as_is" : "centre";
  goal.execution = order.execution;
  return goal;
}

std::uint64_t DriverExecutor::takenThrough(const lamina_msgs::DriveToolpathResult& result) const {
  return result.waypoints;
}

}  // namespace lamina
