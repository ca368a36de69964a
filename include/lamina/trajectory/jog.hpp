// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lamina/kinematics/model/kinematic_model.hpp"
#include "lamina/trajectory/jog_settings.hpp"
#include "lamina/trajectory/trajectory_feeder.hpp"

namespace lamina {

/// The right to move (jog) a machine by hand. It has one holder at a time, and lapses unless the holder
/// renews it within the time of the lease.
class JogLease {
 public:
  explicit JogLease(double lease_s) : lease_s_(lease_s) {}

  /// Gives the lease to a holder, unless somebody else has it, or prolongs it.
  /// @return empty if the holder has it now, else the reason why not, in words
  std::string renew(const std::string& holder, double now_s);
  /// The present holder; empty if there is none.
  std::string holder(double now_s) const { return now_s < until_s_ ? holder_ : std::string(); }

 private:
  double lease_s_;
  double until_s_ = -1.0;
  std::string holder_;
};

/// An order to move joints, or the nozzle, at a velocity until the lease is over.
struct JogOrder {
  enum class Kind { Joints, Nozzle };
  Kind kind = Kind::Joints;
  JointValues rates;                                      ///< of the joints [mm/s, rad/s]; for Joints only
  Eigen::Vector3d linear_mm_s = Eigen::Vector3d::Zero();  ///< velocity of the tip [bed frame]
  Eigen::Vector3d angular_velocity_rad_s =
      Eigen::Vector3d::Zero();  ///< angular velocity about the tip [bed frame]
};

/// How far an order is carried out.
struct JogAnswer {
  double scale = 1.0;  ///< speed at the end of the lease, as a share of the ordered speed
  std::string reason;  ///< why `scale` is less than 1; empty otherwise
};

/// Function that checks whether the joints may pass through these positions in turn; returns the reason why
/// not, in words, or empty.
using JogGuard = std::function<std::string(const std::vector<JointValues>&)>;

/// Function that returns the present time of the caller's clock [s].
using JogClock = std::function<double()>;

/// Moves joints by hand. Each order continues the running motion until the lease is over and then brings it
/// to rest, with bounded accelerations of the joints. So every planned motion ends at rest: if no further
/// order arrives, as after a loss of connection, the motion ends smoothly by itself. Deterministic: all times
/// are those of the caller's clock.
class Jog {
 public:
  /// Starts at rest at time 0. The model must outlive it.
  /// @param ramp_s  time in which a joint goes from rest to its greatest speed, and back
  /// @throws InvalidConfig naming key, value and bound; also if the lease is too short for any motion
  Jog(const KinematicModel& model, const JogSettings& settings, double ramp_s, const JointValues& start);

  /// Plans the motion anew from the first point that can still change. If limits do not allow an order as a
  /// whole, it is carried out at a lower speed, in the same direction. The motion brakes in time for the
  /// limits of joints, for singularities, for the workspace and for the guard. If an order cannot be carried
  /// out at all, the motion brakes. If planning takes so long that the first point has passed, the order has
  /// no effect, and the running motion continues to its rest.
  /// @param clock  used to measure the duration of planning; empty if the duration does not matter
  /// @throws InvalidInput if values are not finite or not those of the model, or the machine cannot move its
  ///   nozzle in this way; the motion then brakes
  JogAnswer order(const JogOrder& order, double now_s, const JogGuard& guard = {},
                  const JogClock& clock = {});

  /// The points planned by the last order. They replace earlier points from the time of the first one on.
  /// Empty if the order came too late.
  const TrajectoryChunk& chunk() const { return chunk_; }
  /// Time at which the planned motion comes to rest [s].
  double restTime() const { return points_.back().time_s; }
  JointState at(double time_s) const;

 private:
  struct Planned;

  Planned planned(const JogOrder& order, const JointState& from, double now_s, double share) const;
  std::string refusalOf(const Planned& plan, const JogGuard& guard) const;
  JointValues ratesFor(const JogOrder& order, const JointValues& position, JogAnswer& answer) const;
  JointValues nozzleRates(const JogOrder& order, const JointValues& position, JogAnswer& answer) const;
  double allowedRate(Eigen::Index joint, const JointState& from, double direction) const;
  bool restsTooNear(const JointState& from, const JointState& last) const;
  JointState stepped(const JointState& from, const JointValues& wanted) const;
  double step() const { return 1.0 / settings_.rate_hz; }
  JointState switchPoint(double now_s) const;
  void take(const std::vector<JointState>& points);

  const KinematicModel& model_;
  JogSettings settings_;
  JointValues acceleration_;  ///< greatest acceleration of each joint
  std::vector<JointState> points_;
  TrajectoryChunk chunk_;
};

}  // namespace lamina
