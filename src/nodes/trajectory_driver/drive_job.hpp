// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "conversions.hpp"
#include "driver_settings.hpp"
#include "lamina/base/progress.hpp"
#include "lamina/job/kinematic_model_run.hpp"
#include "lamina/job/machine_check.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/trajectory/approach.hpp"

namespace lamina {

/// A toolpath that can be driven.
struct DriveJob {
  MachineToolpath placed;
  TimedRun timed;
  double from_mm = 0.0;  ///< of its beads, that are left out with what comes before
};

/// @param found  called with the findings of the check, even if there are none; not called without a check
/// @throws InvalidInput if the toolpath was planned for another machine; Unreachable naming the first
///   waypoint that cannot be run, or where something collides; Cancelled
DriveJob driveJob(const MachineToolpath& placed, const KinematicModel& model, const DriverSettings& settings,
                  const std::function<void(const MachineCheck&)>& found, Progress& progress);

/// The path from the machine's position to the start of a job; nothing if the machine is there.
/// @throws Unreachable if there is no clear path, or the machine is outside its limits; Cancelled
std::optional<Approach> wayToStart(const JointValues& here, const DriveJob& job, const KinematicModel& model,
                                   const DriverSettings& settings, Progress& progress);

}  // namespace lamina
