// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "job/modes/part_planning.hpp"
#include "lamina/parameterization/layer_surface.hpp"
#include "lamina/planning/plan_settings.hpp"

namespace lamina {

/// A layer of a part, whether plane or not.
struct StackedSurface {
  Layer plane;           ///< its section is empty if the layer is not plane
  LayerSurface surface;  ///< without triangles if it is
};

/// Layers in the order they are deposited.
struct SurfaceStack {
  std::vector<StackedSurface> layers;
  /// Highest z of what stands on the bed before the first layer [mm, part frame].
  double standing_mm = -std::numeric_limits<double>::infinity();
};

/// Plans plane layers in their plane, others on their charts, from which they are lifted back. Surfaces are
/// gone when they are flattened. The first and last layers are skins (`skinsOfStack`).
/// @throws Unsliceable with the region, if a piece of a layer does not lie flat; as `planPart`
PlannedPart planStack(SurfaceStack stack, const PlanningRequest& request, Progress& progress);

/// Which layers of a stack are skins: as many of the first and of the last ones as `skins` asks for, by
/// number or by thickness in layers of that height.
std::vector<bool> skinsOfStack(std::size_t layers, const SkinSettings& skins, double layer_height_mm);

}  // namespace lamina
