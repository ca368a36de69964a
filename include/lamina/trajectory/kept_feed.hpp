// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/trajectory/joint_trajectory.hpp"

namespace lamina {

/// Share of its feed below which the tip counts as slow on a bead.
constexpr double kKeptFeed = 0.95;

/// The share of the length of all beads on which the tip is slower than `kKeptFeed` of the toolpath's feed:
/// at their ends, at corners, and where a joint is at its limit. The speed is sampled at eight times of each
/// motion, evenly spaced; 0 if nothing is deposited.
/// @param trajectory  timed from the joint path
/// @param path        joint path of the toolpath
double slowBeadShare(const JointTrajectory& trajectory, const JointPath& path, const Toolpath& toolpath);

/// The same share if a firmware plans the speeds of the tip, as `estimateTime` assumes.
/// @throws InvalidInput if a feed is not positive
double slowBeadShare(const Toolpath& toolpath, const MotionLimits& limits);

}  // namespace lamina
