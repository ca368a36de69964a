// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/job/kinematic_model_run.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/toolpath/waypoint_index.hpp"
#include "lamina/verification/collision/clearance.hpp"
#include "lamina/verification/collision/clearance_settings.hpp"

namespace lamina {

/// A waypoint that a machine or robot cannot run, or on the way to which it cannot.
struct Finding {
  WaypointIndex at;             ///< of the toolpath that was asked for
  Point3 tip = Point3::Zero();  ///< where the nozzle is then [mm, part frame]
  std::string what;             ///< as `toString(JointFault)`, or "collision"
  std::string reason;           ///< for people
  std::size_t line = 0;         ///< of the program that states the joints, 1 based; 0 where none does
};

/// What stands in the way of a toolpath on a machine or robot. Each waypoint is found once for each thing
/// that is wrong with it.
struct MachineCheck {
  std::size_t waypoints = 0;        ///< of the toolpath that was asked for
  std::vector<Finding> faults;      ///< of reach, limits, singularities, in the order of the motion
  std::vector<Finding> collisions;  ///< in the order of the motion
  std::size_t rewinds = 0;          ///< travels on which a rotary joint is wound back

  bool isClear() const { return faults.empty() && collisions.empty(); }
};

/// Where links run into bed, part and each other, and what else is wrong with a run.
///
/// @param progress  stage "clearance"
/// @throws as `checkJointClearance`
MachineCheck checkRun(const KinematicModelRun& run, const KinematicModel& model,
                      const ClearanceSettings& settings, Progress& progress);

/// The collisions of a run, each at a waypoint of the toolpath that was asked for.
///
/// @param progress  stage "clearance"
/// @throws as `checkJointClearance`
ClearanceReport clearanceOf(const KinematicModelRun& run, const KinematicModel& model,
                            const ClearanceSettings& settings, Progress& progress);

/// Where beads come near a singularity, which slows their joints down.
struct SingularBeads {
  std::size_t waypoints = 0;  ///< of beads, as they are led
  std::size_t near = 0;       ///< of these, nearer than the margin
  double least_deg = 90.0;    ///< from a singularity, as `KinematicModel::singularityMargin`
  WaypointIndex at;           ///< the first one that is so near; of the toolpath that was asked for
  std::size_t line = 0;       ///< as in `Finding`

  double share() const {
    return waypoints > 0 ? static_cast<double>(near) / static_cast<double>(waypoints) : 0.0;
  }
};

/// @param margin_deg  `joints.singular_margin_deg`
SingularBeads singularBeads(const KinematicModelRun& run, const KinematicModel& model, double margin_deg);

/// @throws Unreachable if it is not clear: how many waypoints, and the first of them
void requireClear(const MachineCheck& check, const KinematicModel& model);

}  // namespace lamina
