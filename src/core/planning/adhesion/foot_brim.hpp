// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/infill/fill_path.hpp"
#include "lamina/planning/adhesion/adhesion_settings.hpp"
#include "lamina/planning/order/anchoring.hpp"
#include "lamina/slicing/layer.hpp"

namespace lamina {

/// The brim of one inclined layer: lines along its foot on the bed.
struct FootBrim {
  std::vector<FillPath> runs;  ///< in the plane of the layer
  Regions area;                ///< of the layer that they take
};

/// Number of layers before the first one of an inclined part into which its brim may reach.
std::size_t countBrimLayersBelow(const std::vector<Layer>& layers, const BedPlane& bed,
                                 const BrimSettings& settings);

/// A brim of inclined layers: `makeBrim` about what the part covers of the bed, laid as each layer cuts it.
/// Each layer has as many lines along its foot as cover the bed up to the foot of the next layer, at least
/// one. Layers after the part's last one are not added for it.
/// @param layers    in their frame, with those before the part
/// @param width_mm  of its beads, which are as high as their layer
/// @return one per layer
std::vector<FootBrim> footBrim(const std::vector<Layer>& layers, const BedPlane& bed,
                               const BrimSettings& settings, double width_mm);

}  // namespace lamina
