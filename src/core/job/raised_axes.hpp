// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <functional>
#include <string>

#include "lamina/job/job_settings.hpp"
#include "lamina/job/machine_check.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The machine that runs a part, where the part stands on it, and how far its tool axes may be raised.
struct RaisingSite {
  const KinematicModel& model;
  const Eigen::Isometry3d& bed_from_part;
  const JobSettings& settings;  ///< `orientation.max_off_normal_deg`, `clearance.tolerance_mm`
};

/// A toolpath whose tool axes lean less than was wanted, and what a machine still cannot run of it.
struct RaisedToolpath {
  Toolpath toolpath;
  MachineCheck check;         ///< of `toolpath`
  std::size_t waypoints = 0;  ///< number of waypoints of runs that lean less
  double least_kept = 1.0;    ///< least share of the wanted lean that is kept
};

/// Which toolpath raising results in if something is found in every round.
enum class RaiseGoal {
  Clear,   ///< that of the last round
  Fewest,  ///< that of the round with the fewest findings, after which two rounds that leave more are the
           ///< last
};

/// Raises tool axes towards upright: first to the greatest lean at which the head is clear of the bed, then,
/// after each check, where the machine would run into something or cannot get there, as long as a lean
/// decreases, for at most eight rounds.
/// @param check  finds what the machine cannot run of a toolpath
/// @throws as `check`; InvalidConfig as `linkBodies`
RaisedToolpath raiseToolAxes(const Toolpath& wanted, const RaisingSite& site,
                             const std::function<MachineCheck(const Toolpath&)>& check,
                             RaiseGoal goal = RaiseGoal::Clear);

/// A sentence on how many tool axes lean less, and by how much.
std::string noteOnRaised(const RaisedToolpath& raised);

}  // namespace lamina
