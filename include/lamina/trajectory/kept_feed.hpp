// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/trajectory/joint_trajectory.hpp"

namespace lamina {

/// Below this share of its feed a bead counts as slow.
constexpr double kKeptFeed = 0.95;

/// The share of the length of all beads on which the tip is slower than `kKeptFeed` of the feed that the
/// toolpath asks for: at their ends, at corners, and where a joint is at its limit. Looked at in eight places
/// of each motion, evenly in time; 0 where nothing is deposited.
/// @param trajectory  of the joint path, which is that of the toolpath
double slowBeadShare(const JointTrajectory& trajectory, const JointPath& path, const Toolpath& toolpath);

}  // namespace lamina
