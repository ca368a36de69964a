// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <tuple>

namespace lamina {

/// Indices of a waypoint in a toolpath, all from 0: of the layer, of the path in the layer, and of the
/// waypoint in the path.
struct WaypointIndex {
  std::size_t layer = 0;
  std::size_t path = 0;
  std::size_t waypoint = 0;

  friend bool operator==(const WaypointIndex& a, const WaypointIndex& b) {
    return a.layer == b.layer && a.path == b.path && a.waypoint == b.waypoint;
  }
  friend bool operator!=(const WaypointIndex& a, const WaypointIndex& b) { return !(a == b); }
  /// The order of the motion, except for waypoint 0 of a closed path, which is also reached last.
  friend bool operator<(const WaypointIndex& a, const WaypointIndex& b) {
    return std::tie(a.layer, a.path, a.waypoint) < std::tie(b.layer, b.path, b.waypoint);
  }
};

}  // namespace lamina
