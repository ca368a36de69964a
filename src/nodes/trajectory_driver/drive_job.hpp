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

/// @param found  called with what stands in the way, even if that is nothing; not called if no check is made
/// @throws InvalidInput if the toolpath was planned for another machine; Unreachable naming the first
///   waypoint that cannot be run, or where something collides; Cancelled
DriveJob driveJob(const MachineToolpath& placed, const KinematicModel& model, const DriverSettings& settings,
                  const std::function<void(const MachineCheck&)>& found, Progress& progress);

/// The way from where the machine stands to the start of a job; nothing if it stands there.
/// @throws Unreachable if there is none that is clear, or the machine stands outside its limits; Cancelled
std::optional<Approach> wayToStart(const JointValues& here, const DriveJob& job, const KinematicModel& model,
                                   const DriverSettings& settings, Progress& progress);

}  // namespace lamina
