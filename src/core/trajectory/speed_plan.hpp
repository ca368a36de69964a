// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "joint_curve.hpp"
#include "timeline.hpp"

namespace lamina {

/// A piece of a span along which speeds are planned: the straight part of it, or a part of the rounding of
/// one of its ends.
struct CurveCell {
  double start = 0.0;  ///< along the span
  double end = 0.0;
  std::uint32_t span = 0;
  std::int8_t part = 0;  ///< 0 straight; else of the rounding at the start (negative) or end (positive)
};

/// What joints and path allow in a cell. The squared speed x is linear along a cell, its rate of change
/// twice the acceleration s'' along the curve.
struct CellLimits {
  JointValues tangent;             ///< greatest first derivative of each joint
  JointValues bend;                ///< greatest second derivative
  JointValues acceleration;        ///< of the joints [mm/s², rad/s²]
  double path_acceleration = 0.0;  ///< along the curve
  double speed2 = 0.0;             ///< greatest x

  /// Greatest x at one end of a stretch of a cell, from that at the other: tangent |s''| + bend x must not
  /// exceed the acceleration of any joint at the faster end.
  double reachable(double x, double length) const;
  /// Greatest |s''| with which to brake from x.
  double braking(double x) const;
};

/// What speeds are planned for.
struct SpeedsAsked {
  double averaging_s = 0.0;  ///< over which the motion will be averaged to limit jerk; 0 for not at all
  double feed_share = 1.0;   ///< of the toolpath's feeds
};

CellLimits cellLimits(const JointCurve& curve, const CurveCell& cell, const SpeedsAsked& asked);

/// At rest before and after beads [s].
struct Waits {
  double at_start = 0.0;
  double before_bead = 0.0;
  double after_bead = 0.0;
  double averaging_s = 0.0;  ///< rest at every stop at least this long
};

/// What a motion that goes on from a place makes of the plan's rest there.
enum class RestThere : std::uint8_t { Due, Over };

class SpeedPlan;

/// A plan's speeds, slower by one factor everywhere: what takes longer so keeps all limits.
struct SharedSpeeds {
  const SpeedPlan& plan;  ///< along the same curve, nowhere faster than the plan that it is gone over from
  double share = 1.0;     ///< (0, 1]
};

/// The greatest speeds along a curve that all limits allow: one pass back from rest at the end, one forth
/// from rest at the start over its cells (time-optimal path parametrisation by reachability, with the
/// greatest tangent and bend of each cell in place of those at its ends, so that limits hold inside as well).
class SpeedPlan {
 public:
  /// @param feed_share  of the toolpath's feeds, (0, inf): more than 1 is run where all else allows it
  SpeedPlan(const JointCurve& curve, const Waits& waits, double feed_share = 1.0);

  /// The motion from rest at the start to rest at the end.
  const Timeline& timeline() const { return timeline_; }

  /// Adds the way from a place to rest, braking as hard as the limits allow.
  void appendStop(Timeline& out, MotionPlace from) const;
  /// Adds the way from a place, at its speed, to the end: at the speeds of a plan as soon as the limits
  /// allow.
  /// @param from  no faster than this plan is there
  void appendFrom(Timeline& out, MotionPlace from, const SharedSpeeds& speeds, RestThere rest) const;

 private:
  void planSpeeds();
  void limitNodes();
  void buildTimeline(const Waits& waits);
  CellLimits limitsOf(std::size_t cell) const { return cellLimits(*curve_, cells_[cell], asked_); }
  void appendCell(Timeline& out, std::size_t cell, MotionPlace from, double exit2, double share) const;
  double waitAt(std::size_t station, const Waits& waits) const;
  std::size_t cellAt(const MotionPlace& place) const;

  const JointCurve* curve_;
  SpeedsAsked asked_;
  std::vector<CurveCell> cells_;
  std::vector<double> speed2_;  ///< at the start of each cell; one more for the end
  Timeline timeline_;
};

}  // namespace lamina
