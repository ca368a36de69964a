// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"
#include "program/gcode/arc_fit.hpp"

namespace lamina {

/// Which motions of a path arcs may stand for: those of one bead, of feeds within 1 % of their first, at one
/// height, without events between them.
class PathArcs {
 public:
  /// @param places        where the nozzle is in the program: at the start, and at the end of each motion
  /// [mm]
  /// @param tolerance_mm  see `longestArc`
  PathArcs(const Path& path, const std::vector<Point3>& places, double tolerance_mm);

  /// The longest arc that begins with that motion; it ends with motion `last - 1`.
  std::optional<FittedArc> from(std::size_t motion) const;

 private:
  std::vector<Point2> places_;
  std::vector<std::size_t> alike_up_to_;  ///< of each motion: one past the last that is like it
  double tolerance_mm_;
};

}  // namespace lamina
