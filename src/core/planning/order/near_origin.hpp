// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lamina/slicing/layer.hpp"

namespace lamina {

/// Whole metres [mm] by which a layer lies away from the origin, towards which it is moved to be planned:
/// areas are refused beyond 10 m, and layers on a belt may be anywhere. Zero within 5 m, so that usual parts
/// are planned where they are.
Point2 distanceFromOrigin(const Layer& layer);

/// The layer at another place of its plane.
Layer moved(Layer layer, const Point2& by);

}  // namespace lamina
