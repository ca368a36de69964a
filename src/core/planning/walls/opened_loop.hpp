// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/geometry/vector.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A place on a closed path.
struct JoinedLoopPlace {
  std::size_t motion = 0;  ///< that passes it
  double part = 0.0;       ///< of that motion, from its start
  Point3 point = Point3::Zero();
};

/// The place of a closed path that is nearest to a point.
JoinedLoopPlace nearestPlace(const Path& joined_loop, const Point3& point);

enum class LoopSense { AsGiven, Reversed };

/// Where a closed path is opened.
struct LoopOpening {
  JoinedLoopPlace start;
  LoopSense sense = LoopSense::AsGiven;
  double left_out_mm = 0.0;  ///< of its arc, at the end
};

/// The closed path as an open one; the nozzle is turned evenly along motions that are cut. What is left out
/// must be shorter than the path.
Path opened(const Path& joined_loop, const LoopOpening& opening);

/// Where that path ends.
Point3 endOfOpened(const Path& joined_loop, const LoopOpening& opening);

}  // namespace lamina
