// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/mesh/mesh.hpp"
#include "lamina/slicing/planar/layer_stack.hpp"

namespace lamina {

/// A level face of a part at which no layer ends.
struct MissedFlat {
  double z_mm = 0.0;
  double off_mm = 0.0;  ///< distance to the nearest bottom or top of a layer
};

/// Layers whose heights follow the slopes of a part.
struct AdaptiveLayers {
  std::vector<LayerBounds> bounds;  ///< upwards
  std::vector<MissedFlat> missed;   ///< ascending in z
};

/// The highest layers whose steps on the part's surface (cusps) do not exceed `adaptive.cusp_mm`: on a face
/// with the unit normal n, a layer of height h leaves a step of h |n_z|, measured along the normal. Heights
/// stay between `adaptive.least_mm` and `adaptive.greatest_mm`, even if the cusp is then exceeded, and the
/// ratio of neighbouring heights does not exceed `adaptive.greatest_ratio`.
///
/// Layers end at level faces, and at the top of the part, if heights within these bounds allow it. For that,
/// layers between two such heights are made lower, never higher: the excess of each over the least height is
/// reduced by one factor. The first layer has its own height, whatever its cusp. With a quantum, heights are
/// multiples of it, counted from the top of the first layer. Empty if the part is thinner than half the first
/// layer. The time is that of sorting the faces, otherwise linear.
///
/// @param mesh  part, turned so that its layers are level [mm]
/// @throws InvalidConfig if a height is not positive, there is no multiple of the quantum between the least
///   and the greatest height, or more than 10 million layers would result
AdaptiveLayers adaptiveLayers(const Mesh& mesh, const SlicingSettings& settings);

/// The greatest step h |n_z| [mm] that layers leave on faces that are not level.
double greatestCusp(const Mesh& mesh, const std::vector<LayerBounds>& bounds);

}  // namespace lamina
