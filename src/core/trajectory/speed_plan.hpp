// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "joint_curve.hpp"
#include "timeline.hpp"

namespace lamina {

/// A piece of a span for which speeds are planned: its straight part, or part of the rounding at one of its
/// ends.
struct CurveCell {
  double start = 0.0;  ///< position in the span
  double end = 0.0;
  std::uint32_t span = 0;
  /// 0 for the straight part; negative in the rounding at the start, positive in that at the end.
  std::int8_t part = 0;
};

/// Limits of joints and path in a cell. The squared speed x = s'² is linear along a cell, with a slope of
/// twice the acceleration s'' along the curve.
struct CellLimits {
  JointValues tangent;             ///< greatest first derivative of each joint
  JointValues bend;                ///< greatest second derivative
  JointValues acceleration;        ///< greatest acceleration of each joint [mm/s², rad/s²]
  double path_acceleration = 0.0;  ///< along the curve
  double speed2 = 0.0;             ///< greatest x

  /// Greatest x at one end of a stretch of a cell, from that at its other end, such that tangent |s''| + bend
  /// x does not exceed the acceleration limit of any joint at the faster end.
  double reachable(double x, double length) const;
  /// Greatest deceleration |s''| possible at x.
  double braking(double x) const;
};

/// Requirements on the speeds.
struct SpeedsAsked {
  /// Time over which the motion will later be averaged to limit jerk; 0 for no averaging.
  double averaging_s = 0.0;
  double feed_share = 1.0;  ///< factor on the toolpath's feeds
};

CellLimits cellLimits(const JointCurve& curve, const CurveCell& cell, const SpeedsAsked& asked);

/// Times of rest before and after beads [s].
struct Waits {
  double at_start = 0.0;
  double before_bead = 0.0;
  double after_bead = 0.0;
  double averaging_s = 0.0;  ///< least duration of every stop
};

/// For a motion that continues from a position of rest: whether the rest is still to come or over.
enum class RestThere : std::uint8_t { Due, Over };

class SpeedPlan;

/// The speeds of a plan, reduced everywhere by a common factor, which keeps all limits.
struct SharedSpeeds {
  /// Along the same curve, and nowhere faster than the plan from which the motion changes to it.
  const SpeedPlan& plan;
  double share = 1.0;  ///< (0, 1]
};

/// The greatest speeds along a curve that keep all limits: one pass backwards from rest at the end, and one
/// forwards from rest at the start, over its cells (time-optimal path parametrisation by reachability). Each
/// cell uses its greatest tangent and bend instead of those at its ends, so that limits also hold inside it.
class SpeedPlan {
 public:
  /// @param feed_share  factor on the toolpath's feeds, (0, inf); above 1 the motion is faster where all
  ///   other limits allow it
  SpeedPlan(const JointCurve& curve, const Waits& waits, double feed_share = 1.0);

  /// The motion from rest at the start to rest at the end.
  const Timeline& timeline() const { return timeline_; }

  /// Adds the motion from a position to rest, with the greatest deceleration that the limits allow.
  void appendStop(Timeline& out, MotionPlace from) const;
  /// Adds the motion from a position, at its speed, to the end; it takes on the speeds of another plan as
  /// soon as the limits allow.
  /// @param from  position and speed, which must not exceed this plan's
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
  std::vector<double> speed2_;  ///< squared speed at the start of each cell, and one more at the end
  Timeline timeline_;
};

}  // namespace lamina
