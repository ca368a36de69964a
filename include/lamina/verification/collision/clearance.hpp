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

/// What a head can run into.
enum class Obstacle { Bed, Material, Machine };

/// "bed", "material", "machine".
const char* toString(Obstacle obstacle);

/// A toolpath, where its part stands, and what runs it; both must outlive the value.
struct MachineRun {
  const Toolpath& toolpath;
  Eigen::Isometry3d bed_from_part;  ///< [mm]
  const CartesianMachine& machine;
};

/// A place where a body of the machine is in bed, material or another body.
struct Collision {
  WaypointIndex at;             ///< the nozzle is there, or on its way there
  Point3 tip = Point3::Zero();  ///< of the nozzle [mm, bed frame]
  std::string link;             ///< that collides
  Obstacle obstacle = Obstacle::Bed;
  std::string other;        ///< link that it is in; empty but for `CartesianMachine`
  WaypointIndex deposited;  ///< on the way to which the material was deposited; of no meaning for others
  /// Middle of that piece of material, below the tip on the bed, or middle of the body [mm, bed frame].
  Point3 place = Point3::Zero();
};

/// The collisions of a toolpath when it is run.
struct ClearanceReport {
  std::size_t waypoints = 0;               ///< of the toolpath
  std::size_t colliding = 0;               ///< waypoints at which or on the way to which a body collides
  std::vector<Collision> first_of_layers;  ///< of each layer in which one does, in the order of the motion
};

/// Checks a machine's bodies against the bed and all material deposited before, at every waypoint and between
/// them every `spacing_mm` at most, travels too.
///
/// The bed is all that is below z = 0, wider than the plate. A bead is a box as long as its motion and as
/// wide and high as the bead, below the nozzle tip along the layers' normal; it is an obstacle as a whole
/// once the next motion begins, and not while the nozzle lays it. Bed, top and flanks of beads are taken to
/// be `tolerance_mm` farther in than they are, because the tip stands on the top of beads beside its own.
///
/// Shapes are tested by FCL. Beads near a body are found by a tree of the boxes of all beads, in the order of
/// deposition. The same whatever the number of threads.
///
/// @param bodies    none of which is the bed
/// @param progress  stage "clearance"
/// @throws InvalidConfig if there is no body; Cancelled
ClearanceReport checkClearance(const MachineRun& run, const std::vector<MachineBody>& bodies,
                               const ClearanceSettings& settings, Progress& progress);

/// The same for the bodies of the machine's description (`movingBodies`).
ClearanceReport checkClearance(const MachineRun& run, const ClearanceSettings& settings, Progress& progress);

}  // namespace lamina
