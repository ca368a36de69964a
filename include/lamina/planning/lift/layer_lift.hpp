// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A layer where it is deposited in the part.
struct LiftedLayer {
  ToolpathLayer layer;
  double left_out_mm3 = 0.0;  ///< of the plan, for which there is no room where it would be deposited
};

/// Carries a layer that was planned in its plan to where it is deposited in the part: positions,
/// orientations, and beads that fill what their plan filled. Called for several layers at a time.
using LayerLift = std::function<LiftedLayer(std::size_t layer, ToolpathLayer planned)>;

}  // namespace lamina
