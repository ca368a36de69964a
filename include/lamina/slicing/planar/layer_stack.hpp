// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/slicing/slicing_settings.hpp"

namespace lamina {

/// Bottom and top of one planar layer along its normal [mm]. For horizontal layers these are z in the part
/// frame.
struct LayerBounds {
  double bottom_mm = 0.0;
  double top_mm = 0.0;
  double height() const { return top_mm - bottom_mm; }
  /// Height at which the mesh is cut for this layer, its middle.
  double cut() const { return 0.5 * (bottom_mm + top_mm); }
};

/// The layers of a part that reaches from `bottom_mm` to `top_mm`: the first with its own height, the others
/// of equal height. The last layer is kept only if more than half of it is inside the part, as each cut must
/// meet material. Empty if the part is no thicker than half the first layer.
///
/// @throws InvalidConfig if a height is not positive, or more than 10 million layers would result
std::vector<LayerBounds> stackLayers(double bottom_mm, double top_mm, const SlicingSettings& settings);

}  // namespace lamina
