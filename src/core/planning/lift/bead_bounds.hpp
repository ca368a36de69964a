// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace lamina {

/// What is to be laid on one motion of a run.
struct MotionLoad {
  double mm3 = 0.0;
  double usual_mm3 = 0.0;  ///< that a bead of the planned width holds there
  double length_mm = 0.0;
};

/// How much a run may be filled.
struct LoadLimits {
  double fullest = 2.0;   ///< load of a motion, in usual ones
  double reach_mm = 0.4;  ///< length that a load too much for its motion is spread over
  bool is_closed = false;
};

/// What is laid on each motion, and what no motion may take.
struct BoundedLoads {
  std::vector<double> mm3;
  double left_out_mm3 = 0.0;
};

/// Loads that keep the limits. What is too much for a motion is spread over it and its neighbours, on
/// alternate sides until it has room or they are as long as the reach; what has no room then is left out. A
/// longer neighbour takes as much as the part of it within reach has room for.
/// Motions that have nothing too much near them stay exactly as they are. The sum is kept.
BoundedLoads boundLoads(const std::vector<MotionLoad>& motions, const LoadLimits& limits);

}  // namespace lamina
