// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/kinematics/model/link_bodies.hpp"
#include "lamina/verification/collision/clearance.hpp"
#include "lamina/verification/collision/clearance_settings.hpp"

namespace lamina {

/// A toolpath, where its part stands, and what runs it with which joints; all must outlive the value.
struct JointRun {
  const Toolpath& toolpath;
  Eigen::Isometry3d bed_from_part;  ///< [mm]
  const KinematicModel& model;
  const JointPath& path;  ///< of that toolpath; may leave whole layers out
};

/// How a toolpath clears machine and part when it is run with these joints.
struct JointClearanceReport {
  std::size_t waypoints = 0;          ///< that were looked at: those with joint values
  std::vector<Collision> collisions;  ///< the first of each waypoint, in the order of the motion
};

/// Checks every link of a machine or robot, whatever its joints, at every waypoint and on the way there,
/// travels too: against the material deposited before and against the other links and the bed's plate, but
/// for links that hang on each other by one joint (`linkBodies`). Between waypoints the joints go in
/// proportion; the places looked at are `spacing_mm` apart at the nozzle tip at most, and 5 deg of any joint.
///
/// Material is as `checkClearance` has it, but for what the nozzle has just deposited, within one and a half
/// bead widths of its way. On layers that are not plane a bead lies below the tip along the tool axis, as
/// wide as its flat top: such layers lean against each other. It moves with the bed. Links that never move
/// against the bed are not looked for in it. Waypoints without joint values are left out, and so is the way
/// from and to them. Layers that the joint path leaves out are deposited all the same, and the way past them
/// is left out.
///
/// The same whatever the number of threads; n log n in waypoints.
///
/// @param progress  stage "clearance"
/// @throws InvalidConfig if no link that moves against the bed has a body; Cancelled
JointClearanceReport checkJointClearance(const JointRun& run, const LinkBodies& bodies,
                                         const ClearanceSettings& settings, Progress& progress);

}  // namespace lamina
