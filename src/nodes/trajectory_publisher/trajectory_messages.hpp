// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Path.h>
#include <trajectory_msgs/JointTrajectory.h>

#include "conversions.hpp"
#include "lamina/kinematics/machine.hpp"
#include "lamina/toolpath/timing.hpp"

namespace lamina {

/// The waypoints in the part frame, in order, without those nearer than `spacing_mm` to the one before; first
/// and last of each layer always. Header without stamp.
nav_msgs::Path nozzlePath(const Toolpath& toolpath, double spacing_mm);

/// Seconds of a toolpath, from its start.
struct TimeSpan {
  double begin_s = 0.0;
  double end_s = 0.0;
};

/// The axes over a span of time, from its begin, at even steps and at its end.
/// @param player  of the placed toolpath's toolpath
trajectory_msgs::JointTrajectory jointTrajectory(const Machine& machine,
                                                 const Eigen::Isometry3d& bed_from_part,
                                                 ToolpathPlayer& player, const TimeSpan& span, double step_s);

}  // namespace lamina
