// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "lamina/geometry/vector.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "lamina/toolpath/waypoint_index.hpp"

namespace lamina {

/// How a tool axis that leans may be raised.
struct RaiseLimits {
  Point3 up = Point3::UnitZ();    ///< of unit length [part frame]
  double most_deg = 60.0;         ///< by which a tool axis is raised
  double step = 0.25;             ///< of its lean, by which it is raised at a time
  double reach_mm = 2.0;          ///< along a run to both sides, within which its neighbours are raised too
  double most_deg_per_mm = 10.0;  ///< by which the part of the lean that is kept changes along a run
};

/// The lean from upright that a toolpath's tool axes keep, which is lowered place by place.
class KeptLean {
 public:
  /// @param wanted  must outlive this
  KeptLean(const Toolpath& wanted, const RaiseLimits& limits);

  /// Raises the tool axis at a waypoint of a run, and what is near it, by a step. Of a travel, the end of the
  /// run before it and the start of the one after it.
  void raiseAt(const WaypointIndex& at);
  /// Raises the tool axes of all runs so that none leans more than is allowed where it is.
  /// @param most_deg  of the lean, by the place of the tip
  void limit(const std::function<double(const Point3&)>& most_deg);
  /// Whether a tool axis was raised since the last call of `toolpath`.
  bool isChanged() const { return is_changed_; }
  /// The wanted toolpath with its tool axes raised towards straight down, each in the plane of both; travels
  /// turn anew from run to run. A tool axis that points up is not raised.
  Toolpath toolpath();

  /// Least part of the lean that is kept anywhere, 1 if all is.
  double least() const;
  /// Waypoints of runs that keep less than all.
  std::size_t raised() const;

 private:
  struct Run {
    std::size_t layer = 0;
    std::size_t path = 0;
    std::vector<double> kept;   ///< by waypoint; empty while all of it is kept everywhere
    std::vector<double> least;  ///< that may be kept
  };

  const Path& pathOf(const Run& run) const { return wanted_.layers[run.layer].paths[run.path]; }
  void raise(Run& run, std::size_t waypoint);
  void beginRaising(Run& run) const;
  void even(Run& run) const;

  const Toolpath& wanted_;
  RaiseLimits limits_;
  std::vector<Run> runs_;                            ///< in the order of the motion
  std::vector<std::vector<std::size_t>> first_run_;  ///< by layer and path: that run, or the next one
  bool is_changed_ = false;
};

}  // namespace lamina
