// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"
#include "program/gcode/arc_fit.hpp"

namespace lamina {

/// Selects the motions of a path that arcs may replace: consecutive motions with one bead, at one height,
/// with feeds within 1 % of the first feed and no events in between.
class PathArcs {
 public:
  /// @param places        positions of the nozzle in the program: at the start, and at the end of each motion
  ///   [mm]
  /// @param tolerance_mm  see `longestArc`
  PathArcs(const Path& path, const std::vector<Point3>& places, double tolerance_mm);

  /// The longest arc that begins with a motion; its last motion is `last - 1`.
  std::optional<FittedArc> from(std::size_t motion) const;

 private:
  std::vector<Point2> places_;
  /// For each motion one past the last consecutive motion that is like it.
  std::vector<std::size_t> alike_up_to_;
  double tolerance_mm_;
};

}  // namespace lamina
