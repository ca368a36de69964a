// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/slicing/layer.hpp"

namespace lamina {

/// Shift of a layer from the origin, rounded to whole metres [mm], by which it is moved back for planning:
/// operations on regions refuse coordinates beyond 10 m, but layers on a belt may be anywhere. Zero for
/// layers within 5 m, so that usual parts are planned in place.
Point2 distanceFromOrigin(const Layer& layer);
Point2 distanceFromOrigin(const Regions& regions);

/// Successive layers with the same distance from the origin.
struct StackStretch {
  std::size_t begin = 0;
  std::size_t end = 0;
  Point2 away = Point2::Zero();  ///< result of `distanceFromOrigin` [mm]
};

/// Divides a stack into such stretches. An empty layer belongs to the stretch of the layer before; empty
/// layers at the bottom belong to the first stretch.
std::vector<StackStretch> stretchesAlongBelt(const std::vector<Layer>& layers);

/// A layer, or regions, moved in their plane [mm].
Layer moved(Layer layer, const Point2& by);
Regions moved(Regions regions, const Point2& by);

}  // namespace lamina
