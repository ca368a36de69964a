// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A position along a path.
struct CutPlace {
  std::size_t motion = 0;
  double share = 0.0;  ///< of that motion's length, between 0 and 1
};

/// The path with additional waypoints. Deposition, feeds and positions of events are unchanged.
/// @param places  positions of these waypoints, in order along the path
Path withWaypoints(const Path& path, const std::vector<CutPlace>& places);

/// The two open parts of a path. An event at the cut belongs to the second.
/// @param waypoint  not the first or last of an open path
std::pair<Path, Path> cutAt(const Path& path, std::size_t waypoint);

}  // namespace lamina
