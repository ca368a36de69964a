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

/// The desired state of a platform at a time.
struct ReferenceState {
  CrankAngles cranks = CrankAngles::Zero();                ///< angles [rad]
  CrankAngles rates = CrankAngles::Zero();                 ///< [rad/s]
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();  ///< base_from_platform [mm]
};

/// A motion that a controller is to follow.
class TrackingReference {
 public:
  virtual ~TrackingReference() = default;
  virtual double duration() const = 0;  ///< [s]
  /// The desired state at a time: that of the start before 0, that of the end after the duration.
  /// @throws Unreachable stating the time if the platform cannot be there
  virtual ReferenceState at(double time_s) const = 0;
};

/// A toolpath that is run from rest to rest between waypoints. From one waypoint to the next the nozzle turns
/// by the shortest rotation, in proportion to its motion. If a path does not begin with the orientation at
/// the end of the previous path, the nozzle turns on the first motion.
class ToolpathReference final : public TrackingReference {
 public:
  /// @param toolpath  must outlive the reference
  /// @throws InvalidInput as `RestToRestPlayer`
  /// @throws Unreachable if a waypoint is outside the workspace, naming it and each leg that cannot reach it
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
    Point3 turn = Point3::Zero();            ///< rotation vector from there to the end [part frame]
  };
  const Motion& motionTo(const WaypointIndex& end) const;
  Eigen::Isometry3d poseOf(const Point3& tip, const Eigen::Quaterniond& held) const;
  void requireWithin(const WaypointIndex& at, const Eigen::Isometry3d& pose) const;

  RestToRestPlayer player_;
  RusDescription description_;
  Eigen::Isometry3d base_from_part_;
  std::vector<Motion> motions_;  ///< in the order of execution
};

/// A trajectory of the cranks.
class TrajectoryReference final : public TrackingReference {
 public:
  /// @param trajectory  of the six cranks; must outlive the reference
  /// @throws InvalidInput if it has another number of joints
  TrajectoryReference(const JointTrajectory& trajectory, RusPlatform platform);
  double duration() const override { return trajectory_.duration(); }
  ReferenceState at(double time_s) const override;

 private:
  const JointTrajectory& trajectory_;
  RusPlatform platform_;
};

}  // namespace lamina
