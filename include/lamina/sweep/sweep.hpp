// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/sweep/sweep_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// One profile swept along one polyline.
struct Sweep {
  std::vector<Point3> points;  ///< nozzle tip: middle of the top of the bead [mm, part frame]; at least two
  std::vector<Point3> up;  ///< against the tool axis on the way to each point, unit; the first as the second
  Bead bead;               ///< one for the whole trajectory, of its volume
  bool is_loop = false;    ///< ends where it begins, mitred there too
  std::size_t layer = 0;   ///< of the toolpath, 0 based
  std::size_t trajectory = 0;  ///< trajectory that it belongs to, 0 based, skirts not counted

  std::size_t lineCount() const { return points.size() - 1; }
};

/// The sweeps that a toolpath lays: skirts, supports and travel left out. A bead whose section changes along
/// its trajectory has the mean section there, so that its volume stays. Of strategy Lines and Revolved each
/// line is a sweep.
/// @throws InvalidInput if the toolpath is one of drops
std::vector<Sweep> sweepsOf(const Toolpath& toolpath, const SweepSettings& settings);

/// Volume [mm³] of the sweeps were each alone: section times length.
double sweptVolume(const std::vector<Sweep>& sweeps);

}  // namespace lamina
