// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "job/slicing/part_planning.hpp"
#include "lamina/parameterization/layer_surface.hpp"

namespace lamina {

/// A layer of a part, whether plane or not.
struct StackedSurface {
  Layer plane;           ///< its section is empty if the layer is not plane
  LayerSurface surface;  ///< without triangles if it is
};

/// Plans layers in the order they are deposited: plane ones in their plane, others on their charts, from
/// which they are lifted back. Surfaces are gone when they are flattened.
/// @throws Unsliceable with the region, if a piece of a layer does not lie flat; as `planPart`
PlannedPart planStack(std::vector<StackedSurface> stack, const PlanningRequest& request, Progress& progress);

}  // namespace lamina
