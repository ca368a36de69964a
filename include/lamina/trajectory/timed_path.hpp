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

/// Settings of time-parametrisation.
struct TimingSettings {
  MotionLimits motion;  ///< the junction deviation is not used
  TrajectorySettings trajectory;
  ProcessSettings process;
};

/// Checks the settings.
/// @throws InvalidConfig naming key, value and bound
void validate(const TimingSettings& settings);

/// The fastest motion along a joint path within the limits of joints and path, with corners rounded within
/// the tolerance (docs/machines/timing.md). It rests at both ends, where beads begin and end, and for the
/// dwells of the toolpath. Other events, tools and process values are ignored. Linear time and memory.
class TimedPath final : public JointTrajectory {
 public:
  /// The arguments need not outlive the call.
  /// @throws InvalidConfig as `validate`
  /// @throws Unreachable if the joint path has faults, or a bead cannot be followed between its waypoints
  /// @throws InvalidInput if path, toolpath and kinematic model do not fit each other, nothing moves, a feed
  ///   is not positive, drops are deposited, or a bead is too short for the leads of its process
  TimedPath(const Toolpath& toolpath, const JointPath& path, const KinematicModel& model,
            const TimingSettings& settings);
  /// Wraps a motion that was planned in another way.
  explicit TimedPath(std::shared_ptr<const TimedMotion> motion);

  double duration() const override;
  /// Takes logarithmic time.
  JointState at(double time_s) const override;
  const std::vector<double>& stationTimes() const override { return station_times_; }

  /// The switching of the process, in order of time.
  const std::vector<ProcessEvent>& events() const { return events_; }

  /// End waypoints of travels on which the tip deviates from the straight line by more than the tolerance,
  /// for example since an arm changes its configuration.
  const std::vector<WaypointIndex>& looseTravels() const;

  /// The planned motion, for `TrajectoryFeeder`.
  const std::shared_ptr<const TimedMotion>& motion() const { return motion_; }

 private:
  std::shared_ptr<const TimedMotion> motion_;
  std::vector<double> station_times_;
  std::vector<ProcessEvent> events_;
};

/// Total time of a timed joint path, and the time at which each layer starts.
/// @param layers  number of layers of the toolpath; a layer without waypoints starts with the next
ToolpathTime trajectoryTime(const JointTrajectory& trajectory, const JointPath& path, std::size_t layers);

/// The print time on a machine whose joints have limits, with dwells and the waits of the process. For
/// machines with linear axes use `estimateTime`, which considers the tip alone.
/// @throws as `TimedPath`
ToolpathTime estimateJointTime(const Toolpath& toolpath, const JointPath& path, const KinematicModel& model,
                               const TimingSettings& settings);

}  // namespace lamina
