// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/kinematics/joint_path/joint_path.hpp"
#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/toolpath/motion_limits.hpp"
#include "lamina/toolpath/process_levels.hpp"
#include "lamina/trajectory/trajectory_settings.hpp"

namespace lamina {

/// Joints at a place that is passed, and how the way there is to be run.
struct JointStation {
  JointValues values;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< bed_from_nozzle
  WaypointIndex heading_for;
  double length_mm = 0.0;           ///< way of the tip; 0 where it turns in place
  double feed_mm_s = 0.0;           ///< infinite where it turns in place
  double acceleration_mm_s2 = 0.0;  ///< along the path; infinite where it turns in place
  double area_mm2 = 0.0;            ///< cross-section of what is deposited on the way
  double dwell_s = 0.0;             ///< for which the nozzle waits there
  ProcessLevels levels;             ///< on the way, at its feed
  bool is_smooth = false;           ///< no corner of the toolpath: to be rounded whatever the tolerance
};

struct JointStations {
  std::vector<JointStation> each;
  /// Where the stations of the joint path are; stations in one place are one.
  std::vector<std::size_t> of_path;
  /// Ends of travels that the tip does not keep to the straight line of.
  std::vector<WaypointIndex> loose;
};

/// The stations of a joint path, one at least.
/// @throws Unreachable with the first fault of a joint path that has any
/// @throws InvalidInput if the path is empty, does not fit the toolpath or the kinematic model, a feed is not
///   positive, or the toolpath lays drops
JointStations jointStations(const Toolpath& toolpath, const JointPath& path, const KinematicModel& model,
                            const MotionLimits& limits);

/// The stations with more in between where joints that move steadily would take tip or tool axis off the
/// straight way by more than half the tolerance on lines. Travels that cannot be followed are named instead.
/// @throws Unreachable if a bead cannot be followed
JointStations keptOnLines(const JointStations& stations, const KinematicModel& model,
                          const TrajectorySettings& settings);

}  // namespace lamina
