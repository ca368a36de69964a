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

/// @throws Unreachable if it is not clear: how many waypoints, and the first of them
void requireClear(const MachineCheck& check, const KinematicModel& model);

}  // namespace lamina
