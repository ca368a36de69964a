// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

namespace lamina {

/// The volume to be deposited on one motion of a run.
struct MotionLoad {
  double mm3 = 0.0;
  double usual_mm3 = 0.0;  ///< volume of a bead of the planned width there
  double length_mm = 0.0;
};

/// Limits of the loads of a run.
struct LoadLimits {
  double fullest = 2.0;   ///< greatest load of a motion, in usual ones
  double reach_mm = 0.4;  ///< length over which an excess load is spread
  bool is_closed = false;
};

/// The loads within limits, and the volume left out.
struct BoundedLoads {
  std::vector<double> mm3;  ///< by motion
  double left_out_mm3 = 0.0;
};

/// Brings loads within their limits. An excess load is spread over its motion and the neighbours, on
/// alternate sides, until there is room or their length is the reach; the rest is left out. A longer
/// neighbour takes only what its part within reach has room for. Motions without an excess near them stay
/// exactly as they are. The sum of loads and volume left out is kept.
BoundedLoads boundLoads(const std::vector<MotionLoad>& motions, const LoadLimits& limits);

}  // namespace lamina
