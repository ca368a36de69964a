// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nav_msgs/Path.h>
#include <trajectory_msgs/MultiDOFJointTrajectory.h>

#include <vector>

#include "lamina/toolpath/toolpath.hpp"
#include "lamina/trajectory/nozzle_motion.hpp"
#include "messages.hpp"

namespace lamina {

/// The waypoints in the part frame, in order, without those nearer than `spacing_mm` to the one before; first
/// and last of each layer always. Header without stamp.
nav_msgs::Path nozzlePath(const Toolpath& toolpath, double spacing_mm);

/// Pose and twist of the nozzle over the bed, in its frame; times from the first state. Header without stamp.
/// @param states  at least one
trajectory_msgs::MultiDOFJointTrajectory nozzleTrajectory(const std::vector<NozzleState>& states);

/// The process at the same times; safe after the last. Header without stamp.
lamina_msgs::ProcessTrajectory nozzleProcess(const std::vector<NozzleState>& states);

}  // namespace lamina
