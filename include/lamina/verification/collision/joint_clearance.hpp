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

/// A toolpath, the pose of its part, and the joint path by which a machine or robot runs it; all references
/// must outlive the value.
struct JointRun {
  const Toolpath& toolpath;
  Eigen::Isometry3d bed_from_part;  ///< pose of the part [mm]
  const KinematicModel& model;
  const JointPath& path;  ///< of the toolpath; may omit whole layers
};

/// The collisions of a toolpath when it is run by a joint path.
struct JointClearanceReport {
  std::size_t waypoints = 0;          ///< number of waypoints checked: those with joint values
  std::vector<Collision> collisions;  ///< first collision of each waypoint that has any, in their order
};

/// Checks all links of a machine or robot for collisions, at every waypoint and on the motion to it, travels
/// included: with the material deposited before, with the other links and with the plate of the bed. Links
/// that one joint connects are not checked against each other (`linkBodies`). Between waypoints the joints
/// move in proportion; the positions checked are at most `spacing_mm` apart at the nozzle tip, and at most 5
/// deg of any joint.
///
/// Material is modelled as in `checkClearance`, with these differences. It moves with the bed. Material that
/// the nozzle has deposited within the last one and a half bead widths of its motion is no obstacle. On
/// layers that are not plane a bead is below the tip along the tool axis and only as wide as its flat top,
/// since such layers lean against each other. Links that never move relative to the bed are not checked
/// against it. Waypoints without joint values, and the motions to and from them, are not checked. Layers that
/// the joint path omits count as deposited, but the motion past them is not checked.
///
/// The result is the same for any number of threads. Time is n log n in the number of waypoints.
///
/// @param progress  stage "clearance"
/// @throws InvalidConfig if no link that moves relative to the bed has a body; Cancelled
JointClearanceReport checkJointClearance(const JointRun& run, const LinkBodies& bodies,
                                         const ClearanceSettings& settings, Progress& progress);

/// Joint values on a motion beside a toolpath, for example from the start of a program to the part.
struct JointPassage {
  /// Index of the station of the joint path to which the passage leads; the number of stations for a passage
  /// from the last.
  std::size_t before = 0;
  std::vector<JointValues> values;  ///< from the first on; empty where there are none
};

/// A collision on the motion to one of the values of a passage.
struct PassageCollision {
  std::size_t passage = 0;
  std::size_t index = 0;  ///< of the value
  Collision collision;    ///< `at` is the station to which the passage leads, or the last
};

/// Checks motions beside the toolpath as `checkJointClearance` checks those along it: against the material
/// deposited when the motion to the passage's station begins.
/// @return the first collision on the motion to each value that has any, in their order
/// @throws InvalidConfig as `checkJointClearance`
std::vector<PassageCollision> checkJointPassages(const JointRun& run,
                                                 const std::vector<JointPassage>& passages,
                                                 const LinkBodies& bodies, const ClearanceSettings& settings);

}  // namespace lamina
