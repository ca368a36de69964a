// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/slicing/layer.hpp"

namespace lamina {

/// Whole metres [mm] by which a layer lies away from the origin, towards which it is moved to be planned:
/// areas are refused beyond 10 m, and layers on a belt may be anywhere. Zero within 5 m, so that usual parts
/// are planned where they are.
Point2 distanceFromOrigin(const Layer& layer);
Point2 distanceFromOrigin(const Regions& regions);

/// Layers that follow each other and lie equally far out.
struct StackStretch {
  std::size_t begin = 0;
  std::size_t end = 0;
  Point2 away = Point2::Zero();  ///< [mm], of `distanceFromOrigin`
};

/// All layers of a stack, as few stretches as there are. Empty layers belong to those before them.
std::vector<StackStretch> stretchesAlongBelt(const std::vector<Layer>& layers);

/// The same at another place of the plane.
Layer moved(Layer layer, const Point2& by);
Regions moved(Regions regions, const Point2& by);

}  // namespace lamina
