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

/// The right to move a machine by hand. It has one holder at a time, who keeps it only by renewing it again
/// and again.
class JogLease {
 public:
  explicit JogLease(double lease_s) : lease_s_(lease_s) {}

  /// Takes the lease if nobody else holds it, or prolongs it for its holder.
  /// @return why not, in words; empty if it is held now
  std::string renew(const std::string& holder, double now_s);
  /// Empty if nobody holds it.
  std::string holder(double now_s) const { return now_s < until_s_ ? holder_ : std::string(); }

 private:
  double lease_s_;
  double until_s_ = -1.0;
  std::string holder_;
};

/// What joints or nozzle are to do until the lease is over.
struct JogOrder {
  enum class Kind { Joints, Nozzle };
  Kind kind = Kind::Joints;
  JointValues rates;                                      ///< of joints [mm/s, rad/s]
  Eigen::Vector3d linear_mm_s = Eigen::Vector3d::Zero();  ///< of the tip [bed frame]
  Eigen::Vector3d turn_rad_s = Eigen::Vector3d::Zero();   ///< of the nozzle about its tip [bed frame]
};

/// How much of an order is done.
struct JogAnswer {
  double scale = 1.0;  ///< share of the speed asked for, at the end of the lease
  std::string reason;  ///< why it is less than 1; empty otherwise
};

/// Why joints may not stand one after the other in these places, in words; empty if they may.
using JogGuard = std::function<std::string(const std::vector<JointValues>&)>;

/// The time by the clock of a jog [s], also while an order is worked out.
using JogClock = std::function<double()>;

/// Moves joints by hand. Each order continues the motion under way for the time of the lease, and then brings
/// it to rest, with bounded accelerations of the joints. Every planned motion ends at rest. If no further
/// order comes, because some link is broken, the motion therefore ends smoothly by itself. Deterministic: all
/// times are of the caller's clock.
class Jog {
 public:
  /// At rest at time 0. The model must outlive it.
  /// @param ramp_s  in which a joint goes from rest to its greatest speed, and back
  /// @throws InvalidConfig naming key, value and bound; so if the lease ends before anything could move
  Jog(const KinematicModel& model, const JogSettings& settings, double ramp_s, const JointValues& start);

  /// Plans on from the first point that can still change. If the limits do not allow an order, the share of
  /// it that they allow is done, in the same direction. The motion brakes in time for the limits of joints,
  /// for singularities, for the workspace and for the guard. An order that cannot be done at all brakes. An
  /// order that is worked out only after its first point has passed changes nothing: the motion under way
  /// goes on to rest by itself.
  /// @param clock  none for orders that take no time to work out
  /// @throws InvalidInput if values are not finite or not those of the model, or the machine cannot move its
  ///   nozzle so; the motion brakes
  JogAnswer order(const JogOrder& order, double now_s, const JogGuard& guard = {},
                  const JogClock& clock = {});

  /// The points that replace what was handed over before, from the first that the last order has changed;
  /// none if it came too late.
  const TrajectoryChunk& chunk() const { return chunk_; }
  /// When what is planned is at rest [s].
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
  JointValues acceleration_;  ///< greatest, of each joint
  std::vector<JointState> points_;
  TrajectoryChunk chunk_;
};

}  // namespace lamina
