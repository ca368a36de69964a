// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/sweep/sweep_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A profile swept along a polyline. A trajectory is a path that deposits; it consists of one or more sweeps.
struct Sweep {
  std::vector<Point3> points;  ///< nozzle tip, middle of the bead's top [mm, part frame]; at least two
  /// Opposite of the tool axis on the line to each point, of unit length; the first equals the second.
  std::vector<Point3> up;
  Bead bead;                   ///< constant along the trajectory, whose volume is preserved
  bool is_loop = false;        ///< whether it ends where it begins, and is mitred there, too
  std::size_t layer = 0;       ///< index of the layer in the toolpath
  std::size_t trajectory = 0;  ///< index of the trajectory, from 0; skirts do not count

  std::size_t lineCount() const { return points.size() - 1; }
};

/// The sweeps of a toolpath; skirts, supports and travels are left out. A trajectory whose bead varies gets
/// the mean cross-section, which preserves the volume. With the strategies Lines and Revolved each line is a
/// sweep.
/// @throws InvalidInput if the toolpath deposits drops
std::vector<Sweep> sweepsOf(const Toolpath& toolpath, const SweepSettings& settings);

/// Sum of the volumes [mm³] of the sweeps, each its cross-section times its length; overlaps count
/// repeatedly.
double sweptVolume(const std::vector<Sweep>& sweeps);

}  // namespace lamina
