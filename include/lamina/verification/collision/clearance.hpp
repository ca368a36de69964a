// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/kinematics/cartesian/machine_bodies.hpp"
#include "lamina/toolpath/timing.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/verification/collision/clearance_settings.hpp"

namespace lamina {

/// Kind of obstacle with which a body of the machine can collide.
enum class Obstacle { Bed, Material, Machine };

/// The name of a kind: "bed", "material", "machine".
const char* toString(Obstacle obstacle);

/// A toolpath, the pose of its part, and the machine that runs it; toolpath and machine must outlive the
/// value.
struct MachineRun {
  const Toolpath& toolpath;
  Eigen::Isometry3d bed_from_part;  ///< pose of the part [mm]
  const CartesianMachine& machine;
};

/// A collision of a body of the machine with the bed, material or another body.
struct Collision {
  WaypointIndex at;             ///< waypoint at which the nozzle is, or to which it moves
  Point3 tip = Point3::Zero();  ///< position of the nozzle tip [mm, bed frame]
  std::string link;             ///< name of the link that collides
  Obstacle obstacle = Obstacle::Bed;
  std::string other;  ///< name of the link that it collides with; empty unless `obstacle` is Machine
  WaypointIndex
      deposited;  ///< end of the motion that deposited the material; meaningless for other obstacles
  /// For Material the middle of the bead, for Bed the point of the bed below the tip, for Machine the middle
  /// of the body [mm, bed frame].
  Point3 place = Point3::Zero();
};

/// The collisions of a toolpath when it is run.
struct ClearanceReport {
  std::size_t waypoints = 0;  ///< number of waypoints of the toolpath
  std::size_t colliding = 0;  ///< number of those at which, or on the motion to which, a body collides
  std::vector<Collision> first_of_layers;  ///< first collision of each layer that has any, in their order
};

/// Checks the bodies of a machine for collisions with the bed and all material deposited before: at every
/// waypoint, and in between at most `spacing_mm` apart, travels included.
///
/// The bed is the half-space below z = 0. A bead is a box as long as its motion and as wide and high as the
/// bead, below the nozzle tip along the layers' normal. It is an obstacle from the beginning of the next
/// motion on, but not while it is deposited. Bed, and tops and flanks of beads, are moved inwards by
/// `tolerance_mm`, since the tip touches the tops of beads beside its own.
///
/// Shapes are tested by FCL. Beads near a body are found by a tree of the boxes of all beads, in the order of
/// deposition. The result is the same for any number of threads.
///
/// @param bodies    of the machine, without the bed
/// @param progress  stage "clearance"
/// @throws InvalidConfig if there is no body; Cancelled
ClearanceReport checkClearance(const MachineRun& run, const std::vector<MachineBody>& bodies,
                               const ClearanceSettings& settings, Progress& progress);

/// Checks the bodies of the machine's own description (`movingBodies`).
ClearanceReport checkClearance(const MachineRun& run, const ClearanceSettings& settings, Progress& progress);

}  // namespace lamina
