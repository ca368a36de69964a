// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/geometry/vector.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A position on a closed path.
struct JoinedLoopPlace {
  std::size_t motion = 0;  ///< number of the motion on which it lies
  double part = 0.0;       ///< share of that motion's length, from its start
  Point3 point = Point3::Zero();
};

/// The place on a closed path that is nearest to a point.
JoinedLoopPlace nearestPlace(const Path& joined_loop, const Point3& point);

enum class LoopSense { AsGiven, Reversed };

/// How a closed path is opened.
struct LoopOpening {
  JoinedLoopPlace start;
  LoopSense sense = LoopSense::AsGiven;
  double left_out_mm = 0.0;  ///< length left out at its end
};

/// The closed path as an open one. On motions that are cut, the nozzle's orientation is interpolated. The
/// length left out must be less than the length of the path.
Path opened(const Path& joined_loop, const LoopOpening& opening);

/// The end point of the path that `opened` returns.
Point3 endOfOpened(const Path& joined_loop, const LoopOpening& opening);

}  // namespace lamina
