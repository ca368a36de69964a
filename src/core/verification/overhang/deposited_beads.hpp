// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A straight bead, or a drop, by the line through the middle of its section [mm, frame of the layers].
struct DepositedBead {
  Point3 start = Point3::Zero();
  Point3 end = Point3::Zero();
  Bead section;
};

/// Whether the path lays anything anywhere.
bool lays(const Path& path);

/// Calls visit(waypoint) for each waypoint on the way to which something is deposited, in order; for a drop
/// it is deposited there.
template <class Visit>
void forEachDeposited(const Path& path, const Visit& visit) {
  if (!lays(path)) return;
  const bool is_drops = path.deposit == Deposit::Drops;
  const std::size_t count = is_drops ? path.points.size() : path.motionCount();
  for (std::size_t m = 0; m < count; ++m) {
    const std::size_t waypoint = is_drops ? m : path.motionEnd(m);
    const Bead& bead = path.bead.at(waypoint);
    if (bead.width_mm > 0.0 && bead.height_mm > 0.0) visit(waypoint);
  }
}

/// Where the nozzle comes from on its way to a waypoint: the waypoint itself for a drop.
inline const Point3& cameFrom(const Path& path, std::size_t waypoint) {
  if (path.deposit == Deposit::Drops) return path.points[waypoint];
  return path.points[waypoint == 0 ? path.points.size() - 1 : waypoint - 1];
}

/// All beads in the order in which they are deposited, and which of them are of which layer.
struct DepositedBeads {
  std::vector<DepositedBead> beads;
  std::vector<std::size_t> first_of_layer;  ///< index of a layer's first bead; one more entry than layers
};

DepositedBeads depositedBeads(const Toolpath& toolpath);

}  // namespace lamina
