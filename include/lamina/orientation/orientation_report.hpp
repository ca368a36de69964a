// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/toolpath/waypoint_index.hpp"

namespace lamina {

/// The greatest value of an angle, and the waypoint where it occurs.
struct GreatestAngle {
  double value = 0.0;
  WaypointIndex at;
};

enum class OrientationLimit { Lean, Turn };

/// A run on which a limit changed the tool axis.
struct LimitHit {
  OrientationLimit limit = OrientationLimit::Lean;
  WaypointIndex worst;        ///< where wanted and given tool axis differ most
  double wanted_deg = 0.0;    ///< at `worst`: the wanted lean, or the wanted turn from the waypoint before
  double given_deg = 0.0;     ///< at `worst`: the lean or turn after the limit
  std::size_t waypoints = 0;  ///< number of waypoints of the run at which the tool axis was changed
};

/// How the nozzle rotates along a toolpath, and what limits changed.
struct OrientationReport {
  GreatestAngle lean_deg;                  ///< of the tool axis from straight down
  GreatestAngle step_deg;                  ///< rotation of the nozzle from one waypoint to the next
  GreatestAngle turn_deg_per_mm;           ///< that rotation over the length of the motion, in runs
  GreatestAngle travel_deg_per_mm;         ///< the same quotient in travels, which no limit changes
  std::vector<LimitHit> limits_hit;        ///< in the order of the runs
  std::size_t waypoints_without_wall = 0;  ///< of walls, in mode wall (`wallFollowingToolAxes`)
};

}  // namespace lamina
