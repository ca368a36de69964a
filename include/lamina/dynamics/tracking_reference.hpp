// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "lamina/kinematics/platform/rus_description.hpp"
#include "lamina/kinematics/platform/rus_kinematics.hpp"
#include "lamina/trajectory/joint_trajectory.hpp"
#include "lamina/trajectory/rest_to_rest.hpp"

namespace lamina {

/// Where a platform should be at one instant.
struct ReferenceState {
  CrankAngles cranks = CrankAngles::Zero();                ///< [rad]
  CrankAngles rates = CrankAngles::Zero();                 ///< [rad/s]
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< base_from_platform [mm]
};

/// What a controller is to follow.
class TrackingReference {
 public:
  virtual ~TrackingReference() = default;
  virtual double duration() const = 0;  ///< [s]
  /// Before 0 at the start, after the duration at the end.
  /// @throws Unreachable if the platform cannot be there, with the time
  virtual ReferenceState at(double time_s) const = 0;
};

/// A toolpath from rest to rest at every waypoint. Between two waypoints the nozzle turns along the shortest
/// way, in step with its motion; where a path starts with the nozzle held otherwise than the one before
/// ended, it turns on the first motion.
class ToolpathReference final : public TrackingReference {
 public:
  /// @param toolpath  must outlive the reference
  /// @throws InvalidInput as `RestToRestPlayer`
  /// @throws Unreachable if a waypoint is outside the workspace, naming it and every leg at fault
  ToolpathReference(const Toolpath& toolpath, const Eigen::Isometry3d& bed_from_part,
                    const MotionLimits& limits, RusDescription description);
  double duration() const override { return player_.duration(); }
  ReferenceState at(double time_s) const override;

 private:
  /// One motion as the player runs it.
  struct Motion {
    WaypointIndex end;
    Point3 start = Point3::Zero();
    double length_mm = 0.0;
    Eigen::Quaterniond held = nozzleDown();  ///< part_from_nozzle at the start
    Point3 turn = Point3::Zero();            ///< from there to the end, as a rotation vector [part frame]
  };
  const Motion& motionTo(const WaypointIndex& end) const;
  Eigen::Isometry3d poseOf(const Point3& tip, const Eigen::Quaterniond& held) const;
  void requireWithin(const WaypointIndex& at, const Eigen::Isometry3d& pose) const;

  RestToRestPlayer player_;
  RusDescription description_;
  Eigen::Isometry3d base_from_part_;
  std::vector<Motion> motions_;  ///< in the order of the motion
};

/// Joints over time.
class TrajectoryReference final : public TrackingReference {
 public:
  /// @param trajectory  of the six cranks; must outlive the reference
  TrajectoryReference(const JointTrajectory& trajectory, RusPlatform platform);
  double duration() const override { return trajectory_.duration(); }
  ReferenceState at(double time_s) const override;

 private:
  const JointTrajectory& trajectory_;
  RusPlatform platform_;
};

}  // namespace lamina
