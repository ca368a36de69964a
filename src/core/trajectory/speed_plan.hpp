// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "trajectory/curve_cells.hpp"
#include "trajectory/timeline.hpp"

namespace lamina {

/// At rest before and after beads [s].
struct Waits {
  double at_start = 0.0;
  double before_bead = 0.0;
  double after_bead = 0.0;
  double averaging_s = 0.0;  ///< rest at every stop at least this long
};

/// The greatest speeds along a curve that all limits allow: one pass back from rest at the end, one forth
/// from rest at the start over its cells (time-optimal path parametrisation by reachability, with the
/// greatest tangent and bend of each cell in place of those at its ends, so that limits hold inside as well).
class SpeedPlan {
 public:
  SpeedPlan(const JointCurve& curve, const Waits& waits);

  /// The motion from rest at the start to rest at the end.
  const Timeline& timeline() const { return timeline_; }

  /// Adds the way from a place to rest, braking as hard as the limits allow.
  void appendStop(Timeline& out, MotionPlace from) const;
  /// Adds the way from rest at a place to the end, at the plan's speed as soon as it is reached.
  void appendRestart(Timeline& out, MotionPlace from) const;

 private:
  void planSpeeds();
  void limitNodes();
  void buildTimeline(const Waits& waits);
  CellLimits limitsOf(std::size_t cell) const { return cellLimits(*curve_, cells_[cell], averaging_s_); }
  void appendCell(Timeline& out, std::size_t cell, MotionPlace from, double exit2) const;
  double waitAt(std::size_t station, const Waits& waits) const;
  std::size_t cellAt(const MotionPlace& place) const;

  const JointCurve* curve_;
  double averaging_s_;
  std::vector<CurveCell> cells_;
  std::vector<double> speed2_;  ///< at the start of each cell; one more for the end
  Timeline timeline_;
};

}  // namespace lamina
