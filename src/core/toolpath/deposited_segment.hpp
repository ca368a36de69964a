// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Whether a path belongs to the part: it deposits, and not as a build aid.
inline bool isPartOfPart(const Path& path) {
  const RoleKind kind = kindOf(path.role);
  return kind == RoleKind::Wall || kind == RoleKind::Infill;
}

/// Whether a path lays beads, of the part or of a build aid.
inline bool laysBeads(const Path& path) {
  return path.role != PathRole::Travel && path.deposit == Deposit::Bead;
}

/// A segment that is deposited: a bead along one motion, or a drop, which starts and ends at the same
/// waypoint. The path must outlive the segment.
struct DepositedSegment {
  std::size_t from = 0;      ///< waypoint at which it starts
  std::size_t waypoint = 0;  ///< waypoint at which it ends, whose bead and orientation it has
  const Point3& start;       ///< position of the nozzle tip at the start [mm, part frame]
  const Point3& end;
  const Bead& bead;

  double length() const { return (end - start).norm(); }
  /// Whether its cross-section has no area: nothing is deposited.
  bool isEmpty() const { return !(bead.width_mm > 0.0 && bead.height_mm > 0.0); }
};

/// Calls visit(segment) for each motion of a path of beads, or each drop of a path of drops, in order of
/// deposition, including empty ones. A travel has no segments. A closed path of beads ends with the segment
/// back to its start.
template <class Visit>
void forEachDepositedSegment(const Path& path, const Visit& visit) {
  if (path.role == PathRole::Travel) return;
  const bool is_drops = path.deposit == Deposit::Drops;
  const std::size_t count = is_drops ? path.points.size() : path.motionCount();
  for (std::size_t from = 0; from < count; ++from) {
    const std::size_t waypoint = is_drops ? from : path.motionEnd(from);
    visit(DepositedSegment{from, waypoint, path.points[from], path.points[waypoint], path.bead.at(waypoint)});
  }
}

}  // namespace lamina
