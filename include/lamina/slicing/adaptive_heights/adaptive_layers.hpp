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
  double off_mm = 0.0;  ///< to the nearest end of a layer
};

/// Layers whose heights follow the slopes of a part.
struct AdaptiveLayers {
  std::vector<LayerBounds> bounds;
  std::vector<MissedFlat> missed;  ///< ascending
};

/// The highest layers that leave no step above `adaptive.cusp_mm` on the part's surface: on a face whose unit
/// normal is n, a layer of height h leaves one of h |n_z|, measured along the normal. Heights keep to
/// `adaptive.least_mm` and `adaptive.greatest_mm`, whatever the cusp, and neighbouring ones to
/// `adaptive.greatest_ratio`.
///
/// Layers end at level faces, and at the top of the part, where heights within these bounds allow it: between
/// two of them layers are made lower, never higher, all by the same share of what they have above the least
/// height. The first layer has its own height, whatever its cusp. Heights with a quantum are multiples of it,
/// counted from the first layer's top. Empty if the part is thinner than half the first layer. Linear in the
/// faces, but for sorting them.
///
/// @param mesh  level layers across z [mm]
/// @throws InvalidConfig if a height is not positive, there is no multiple of the quantum between the least
/// and the greatest height, or more than 10 million layers would result
AdaptiveLayers adaptiveLayers(const Mesh& mesh, const SlicingSettings& settings);

/// The greatest step h |n_z| [mm] that layers leave on the faces that are not level.
double greatestCusp(const Mesh& mesh, const std::vector<LayerBounds>& bounds);

}  // namespace lamina
