// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/trajectory/joint_trajectory.hpp"
#include "lamina/trajectory/process_events.hpp"
#include "lamina/trajectory/process_settings.hpp"
#include "lamina/trajectory/trajectory_settings.hpp"

namespace lamina {

class TimedMotion;

/// All that time-parametrisation is asked.
struct TimingSettings {
  MotionLimits motion;  ///< the junction deviation is not used
  TrajectorySettings trajectory;
  ProcessSettings process;
};

/// @throws InvalidConfig naming key, value and bound
void validate(const TimingSettings& settings);

/// The fastest motion along a joint path within the limits of joints and path, corners rounded within the
/// tolerance (docs/machines/timing.md). At rest at both ends, where beads begin and end, and for the dwells
/// of the toolpath. Other events, tools and process values are left out. Linear time and memory.
class TimedPath final : public JointTrajectory {
 public:
  /// Nothing given is needed afterwards.
  /// @throws InvalidConfig as `validate`
  /// @throws Unreachable if the joint path has faults, or a bead cannot be followed between its waypoints
  /// @throws InvalidInput if path, toolpath and kinematic model do not fit each other, nothing moves, a feed
  ///   is not positive, drops are deposited, or a bead is too short for the leads of its process
  TimedPath(const Toolpath& toolpath, const JointPath& path, const KinematicModel& model,
            const TimingSettings& settings);
  /// A motion that was planned otherwise.
  explicit TimedPath(std::shared_ptr<const TimedMotion> motion);

  double duration() const override;
  /// Logarithmic time.
  JointState at(double time_s) const override;
  const std::vector<double>& stationTimes() const override { return station_times_; }

  /// What is switched when, in order.
  const std::vector<ProcessEvent>& events() const { return events_; }

  /// Ends of travels on which the tip leaves the straight line by more than the tolerance, as where an arm
  /// changes its configuration.
  const std::vector<WaypointIndex>& looseTravels() const;

  /// What hand-over goes on from.
  const std::shared_ptr<const TimedMotion>& motion() const { return motion_; }

 private:
  std::shared_ptr<const TimedMotion> motion_;
  std::vector<double> station_times_;
  std::vector<ProcessEvent> events_;
};

/// Total time and that of each layer's start, of a timed joint path.
/// @param layers  of the toolpath; one without waypoints starts with the next
ToolpathTime trajectoryTime(const JointTrajectory& trajectory, const JointPath& path, std::size_t layers);

/// The print time of a machine whose joints have limits, dwells and waits of the process included: what
/// `estimateTime` of the tip alone is for machines with linear axes.
/// @throws as `TimedPath`
ToolpathTime estimateJointTime(const Toolpath& toolpath, const JointPath& path, const KinematicModel& model,
                               const TimingSettings& settings);

}  // namespace lamina
