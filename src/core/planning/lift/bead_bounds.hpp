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
  double fullest = 2.0;   ///< greatest load of a motion, in multiples of its usual load
  double reach_mm = 0.4;  ///< length over which an excess load is spread
  bool is_closed = false;
};

/// The loads within limits, and the volume left out.
struct BoundedLoads {
  std::vector<double> mm3;  ///< by motion
  double left_out_mm3 = 0.0;
};

/// Brings loads within their limits. An excess load is spread over the motion and its neighbours, on
/// alternate sides, until it has room or the reach is used up; the rest is left out. A neighbour longer than
/// the remaining reach takes only what its part within reach has room for. Motions without an excess near
/// them are not changed at all. The sum of loads and volume left out stays the same.
BoundedLoads boundLoads(const std::vector<MotionLoad>& motions, const LoadLimits& limits);

}  // namespace lamina
