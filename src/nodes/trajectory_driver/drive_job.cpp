// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#include "drive_job.hpp"

#include <cmath>
#include <utility>

#include "lamina/job/clear_approach.hpp"
#include "lamina/job/drivable_toolpath.hpp"
#include "lamina/trajectory/trajectory_feeder.hpp"

namespace lamina {
namespace {

constexpr double kThere = 1e-4;  // s at a joint's greatest speed: what encoders and lag leave of a way

bool isThere(const JointValues& here, const JointValues& start, const KinematicModel& model) {
  for (Eigen::Index j = 0; j < start.size(); ++j)
    if (std::abs(here[j] - start[j]) > kThere * model.joints()[static_cast<std::size_t>(j)].max_speed)
      return false;
  return true;
}

}  // namespace

DriveJob driveJob(const MachineToolpath& placed, const KinematicModel& model, const DriverSettings& settings,
                  const std::function<void(const MachineCheck&)>& found, Progress& progress) {
  requirePlannedFor(placed, model.name());
  const CheckedMachine machine(model);
  if (settings.is_clearance_checked) {
    KinematicModelRun run = drivableRun({placed.toolpath, placed.bed_from_part}, machine,
                                        {settings.run.joints, settings.clearance}, found, progress);
    return {placed, inTime(std::move(run), model, settings.run.timing)};
  }
  requireDrivable(placed.toolpath);
  KinematicModelRun run =
      runOn(machine, placed.toolpath, placed.bed_from_part, settings.run.joints, progress);
  return {placed, inTime(std::move(run), model, settings.run.timing)};
}

std::optional<Approach> wayToStart(const JointValues& here, const DriveJob& job, const KinematicModel& model,
                                   const DriverSettings& settings, Progress& progress) {
  const JointValues start =
      TrajectoryFeeder(*job.timed.trajectory, settings.feeder, job.from_mm).at(0.0).position;
  if (isThere(here, start, model)) return std::nullopt;
  if (!settings.is_clearance_checked)
    return approach(here, start, model, settings.approach, settings.run.timing);
  return clearApproach(here, start, model, {settings.approach, settings.run.timing, settings.clearance},
                       progress);
}

}  // namespace lamina
