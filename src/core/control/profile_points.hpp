// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/control/profile_reading.hpp"

namespace lamina {

/// The valid points of a profile, in its order.
struct SoundPoints {
  std::vector<Point3> points;        ///< [mm, frame of the sensor]
  std::vector<std::size_t> columns;  ///< first point of each column, and the number of points; a column has
                                     ///< all returns along one ray
  PointCounts counts;                ///< number of points left out, by reason
};

/// Leaves out the ends of a profile, points that are not finite or outside the sensor's window, and spray.
/// @param layer_mm  height of the layer
SoundPoints soundPoints(const std::vector<Point3>& points, double layer_mm, const SightSettings& settings);

}  // namespace lamina
