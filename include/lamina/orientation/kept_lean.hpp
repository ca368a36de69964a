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

/// How far and by which steps leaning tool axes may be raised.
struct RaiseLimits {
  Point3 up = Point3::UnitZ();    ///< upwards, of unit length [part frame]
  double most_deg = 60.0;         ///< greatest angle by which a tool axis is raised
  double step = 0.25;             ///< share of the wanted lean by which a tool axis is raised at a time
  double reach_mm = 2.0;          ///< length of the run, to both sides, over which neighbours are raised too
  double most_deg_per_mm = 10.0;  ///< greatest change of the kept lean along a run
};

/// The lean of a toolpath's tool axes, and the share of it that is kept at each waypoint. Raising a tool axis
/// lowers that share.
class KeptLean {
 public:
  /// @param wanted  must outlive this
  KeptLean(const Toolpath& wanted, const RaiseLimits& limits);

  /// Raises the tool axis at a waypoint of a run, and those within reach, by a step. For a waypoint of a
  /// travel, raises those at the end of the run before it and at the start of the run after it.
  void raiseAt(const WaypointIndex& at);
  /// Raises the tool axes of all runs so that none leans more than is allowed at its place, as far as
  /// `RaiseLimits::most_deg` permits.
  /// @param most_deg  greatest lean, by the position of the tip
  void limit(const std::function<double(const Point3&)>& most_deg);
  /// Whether a tool axis was raised since the last call of `toolpath`.
  bool isChanged() const { return is_changed_; }
  /// The wanted toolpath with its tool axes raised: each is rotated towards straight down, in the plane
  /// through both. Along travels they are interpolated anew from run to run. A tool axis that points up is
  /// not raised.
  Toolpath toolpath();

  /// Least share of the lean that is kept at any waypoint; 1 if all of it is.
  double least() const;
  /// Number of waypoints of runs that keep less than all of their lean.
  std::size_t raised() const;

 private:
  struct Run {
    std::size_t layer = 0;
    std::size_t path = 0;
    std::vector<double> kept;   ///< share that is kept, by waypoint; empty while the whole lean is kept
    std::vector<double> least;  ///< least share that may be kept, by waypoint
  };

  const Path& pathOf(const Run& run) const { return wanted_.layers[run.layer].paths[run.path]; }
  void raise(Run& run, std::size_t waypoint);
  void beginRaising(Run& run) const;
  void even(Run& run) const;

  const Toolpath& wanted_;
  RaiseLimits limits_;
  std::vector<Run> runs_;  ///< in the order of the motion
  /// By layer and path: the first run of the path, or the next one.
  std::vector<std::vector<std::size_t>> first_run_;
  bool is_changed_ = false;
};

}  // namespace lamina
