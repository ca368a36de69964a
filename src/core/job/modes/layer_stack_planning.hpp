// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>
#include <vector>

#include "job/modes/part_planning.hpp"
#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/parameterization/layer_surface.hpp"

namespace lamina {

/// A layer of a part, plane or curved.
struct StackedSurface {
  Layer plane;           ///< with an empty section if the layer is curved
  LayerSurface surface;  ///< without triangles if the layer is plane
};

/// Layers in the order they are deposited.
struct SurfaceStack {
  std::vector<StackedSurface> layers;
  /// Highest z of solid material on the bed before the first layer, such as a base [mm, part frame].
  double standing_mm = -std::numeric_limits<double>::infinity();
  /// The part that the layers fill, for the skins of its steps; empty if they fill none, as a coat does.
  Mesh part = {};
};

/// Plans plane layers in their plane, and curved layers on flat charts from which the paths are lifted back.
/// The surface of a layer is freed once it is flattened. The first and the last layers are skins as a whole
/// (`skinsOfStack`); others where the part is seen from above or below (`coversOfStack`).
/// @throws Unsliceable with the region if a piece of a layer cannot be flattened; as `planPart`
PlannedPart planStack(SurfaceStack stack, const PlanningRequest& request, Progress& progress);

}  // namespace lamina
