// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/job/kinematic_model_run.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/toolpath/waypoint_index.hpp"
#include "lamina/verification/collision/checked_machine.hpp"
#include "lamina/verification/collision/clearance.hpp"
#include "lamina/verification/collision/clearance_settings.hpp"

namespace lamina {

/// A fault or collision of a machine or robot at a waypoint, or on the motion to the waypoint.
struct Finding {
  WaypointIndex at;             ///< waypoint of the requested toolpath
  Point3 tip = Point3::Zero();  ///< position of the nozzle tip at the fault or collision [mm, part frame]
  std::string what;             ///< kind: `toString(JointFault)`, or "collision"
  std::string reason;           ///< explanation for people
  std::size_t line = 0;  ///< line of the program that states joint values, from 1; 0 for no such program
  /// The link that collides and what it meets, "link 'head' in the bed"; empty for faults.
  std::string meeting = {};
};

/// Faults and collisions of a toolpath on a machine or robot. A waypoint is listed once for each kind.
struct MachineCheck {
  std::size_t waypoints = 0;        ///< number of waypoints of the requested toolpath
  std::vector<Finding> faults;      ///< faults of reach, limits, singularities, in the order of the motion
  std::vector<Finding> collisions;  ///< in the order of the motion
  std::size_t rewinds = 0;          ///< number of travels on which a rotary joint is wound back
  /// Pairs of links, other than neighbours, that move relative to each other but are not checked: the
  /// description exempts them, or they are built into each other (`checkedBodies`).
  std::vector<std::pair<std::string, std::string>> ignored;

  /// A sentence on the unknown part of the motion to the part; empty if all is known.
  std::string unknown_way = {};

  bool isClear() const { return faults.empty() && collisions.empty(); }
};

/// Checks a run: lists its faults, and collisions of links with the bed, the part or each other, along the
/// part and on the motions to the part, away from the part and between files of the program. Findings on such
/// a motion are listed at the waypoint to which the motion leads, or at the last waypoint, once for each line
/// of the program.
///
/// @param progress  stage "clearance"
/// @throws as `checkJointClearance`
MachineCheck checkRun(const KinematicModelRun& run, const CheckedMachine& machine,
                      const ClearanceSettings& settings, Progress& progress);

/// Checks only the motions of a run beside the part.
/// @throws as `checkJointPassages`
MachineCheck checkPassages(const KinematicModelRun& run, const CheckedMachine& machine,
                           const ClearanceSettings& settings);

/// The same as `checkRun` for a single check: the `CheckedMachine` is made for the call.
MachineCheck checkRun(const KinematicModelRun& run, const KinematicModel& model,
                      const ClearanceSettings& settings, Progress& progress);

/// The collisions of a run, each assigned to a waypoint of the requested toolpath.
///
/// @param progress  stage "clearance"
/// @throws as `checkJointClearance`
ClearanceReport clearanceOf(const KinematicModelRun& run, const CheckedMachine& machine,
                            const ClearanceSettings& settings, Progress& progress);

/// How close the joints come to a singularity along beads; joints slow down close to a singularity.
struct SingularBeads {
  /// Number of waypoints of beads in the divided toolpath, without those that have no joint values.
  std::size_t waypoints = 0;
  std::size_t near = 0;     ///< number of these that are nearer to a singularity than the margin
  double least_deg = 90.0;  ///< least distance from a singularity, from `KinematicModel::singularityMargin`
  WaypointIndex at;         ///< the first waypoint at that distance, in the requested toolpath
  std::size_t line = 0;     ///< line of the program, as in `Finding`

  double share() const {
    return waypoints > 0 ? static_cast<double>(near) / static_cast<double>(waypoints) : 0.0;
  }
};

/// Measures how close beads come to a singularity.
/// @param margin_deg  `joints.singular_margin_deg`
SingularBeads singularBeads(const KinematicModelRun& run, const KinematicModel& model, double margin_deg);

/// Checks that there are neither faults nor collisions.
/// @throws Unreachable otherwise, stating the number of findings, the first finding, and for each link that
///   collides the number of waypoints and the first layer
void requireClear(const MachineCheck& check, const KinematicModel& model);

}  // namespace lamina
