// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A layer at its place in the part.
struct LiftedLayer {
  ToolpathLayer layer;
  double left_out_mm3 = 0.0;  ///< planned volume for which the layer has no room
};

/// Lifts a layer from its flat plan to its place in the part: positions, orientations, and beads with the
/// volume of their plan. Called for several layers at a time.
using LayerLift = std::function<LiftedLayer(std::size_t layer, ToolpathLayer planned)>;

}  // namespace lamina
