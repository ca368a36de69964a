// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/control/profile_reading.hpp"

namespace lamina {

/// Points of a profile that are sound, in its order.
struct SoundPoints {
  std::vector<Point3> points;        ///< [mm, frame of the sensor]
  std::vector<std::size_t> columns;  ///< first point of each column, and one more: of several returns
                                     ///< along one ray all
  PointCounts counts;                ///< of those left out
};

/// Leaves out the ends, points that are none, those outside the sensor's window, and spray.
/// @param layer_mm  height of the layer
SoundPoints soundPoints(const std::vector<Point3>& points, double layer_mm, const SightSettings& settings);

}  // namespace lamina
