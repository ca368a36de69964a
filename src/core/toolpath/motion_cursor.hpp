// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/toolpath/timing.hpp"

namespace lamina {

/// Steps through the motions of a toolpath, in order. Motions shorter than any machine resolves are skipped.
class MotionCursor {
 public:
  explicit MotionCursor(const Toolpath& toolpath)
      : MotionCursor(toolpath.layers.data(), toolpath.layers.size()) {}
  MotionCursor(const ToolpathLayer* first, std::size_t count) : layers_(first), count_(count) {}

  /// Moves to the next motion; at the first call, to the first one. Returns false after the last one.
  bool step();

  /// The path of the current motion.
  const Path& path() const { return layers_[layer_].paths[path_]; }
  const Point3& start() const { return path().points[motion_]; }
  const Point3& end() const { return path().points[path().motionEnd(motion_)]; }
  double length() const { return length_mm_; }
  std::size_t startWaypoint() const { return motion_; }
  WaypointIndex endWaypoint() const { return {layer_, path_, path().motionEnd(motion_)}; }
  MotionSegment segment(const MotionLimits& limits) const;
  /// Time for which the nozzle waits before this motion [s].
  double dwell() const { return dwell_s_; }

 private:
  bool stepAny();
  double dwellHere() const;

  const ToolpathLayer* layers_;
  std::size_t count_;
  std::size_t layer_ = 0;
  std::size_t path_ = 0;
  std::size_t motion_ = 0;
  bool is_started_ = false;
  double length_mm_ = 0.0;
  double dwell_s_ = 0.0;
};

}  // namespace lamina
