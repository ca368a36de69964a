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

/// Joint values at a station, with the properties of the motion that leads there.
struct JointStation {
  JointValues values;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< bed_from_nozzle
  WaypointIndex heading_for;
  double length_mm = 0.0;           ///< length of the tip's path; 0 if it turns in place
  double feed_mm_s = 0.0;           ///< infinite if it turns in place
  double acceleration_mm_s2 = 0.0;  ///< along the path; infinite if it turns in place
  double area_mm2 = 0.0;            ///< cross-section of what is deposited on this motion
  double dwell_s = 0.0;             ///< time for which the nozzle waits at the station
  ProcessLevels levels;             ///< on this motion, at its feed
  /// Whether the toolpath has no corner here, so that the curve is rounded whatever the tolerance.
  bool is_smooth = false;
};

struct JointStations {
  std::vector<JointStation> each;
  /// For each station of the joint path, the index of its station here; consecutive stations with the same
  /// pose share one.
  std::vector<std::size_t> of_path;
  /// Ends of travels during which the tip leaves the straight line.
  std::vector<WaypointIndex> loose;
};

/// The stations of a joint path; at least one.
/// @throws Unreachable with the first fault of a joint path that has any
/// @throws InvalidInput if the path is empty, does not fit the toolpath or the kinematic model, a feed is not
///   positive, or the toolpath lays drops
JointStations jointStations(const Toolpath& toolpath, const JointPath& path, const KinematicModel& model,
                            const MotionLimits& limits);

/// The stations with more inserted where steadily moving joints would take tip or tool axis off the straight
/// line by more than half the tolerance on lines. Travels for which this is not possible are listed in
/// `loose` instead.
/// @throws Unreachable if a bead cannot follow its line
JointStations keptOnLines(const JointStations& stations, const KinematicModel& model,
                          const TrajectorySettings& settings);

}  // namespace lamina
