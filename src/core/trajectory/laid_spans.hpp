// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/trajectory/trajectory_feeder.hpp"
#include "trajectory/timeline.hpp"

namespace lamina {

/// What of its beads is laid along a curve, which must outlive it.
class LaidSpans {
 public:
  explicit LaidSpans(const JointCurve& curve);

  /// At a place of the curve.
  LaidAmount at(const MotionPlace& place) const;
  /// The place at rest from which a length of beads is gone on with: on the bead, or at the start of the
  /// next.
  /// @throws InvalidInput if nothing is laid after that length
  MotionPlace placeOf(double length_mm) const;

 private:
  double lengthOf(std::size_t span) const;

  const JointCurve* curve_;
  std::vector<LaidAmount> laid_;  ///< at the start of each span, and one more at the end
};

}  // namespace lamina
