// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/planning/order/anchoring.hpp"
#include "lamina/slicing/layer.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// How many runs of beads begin with neither bed nor the layer before below them. A run that goes on where
/// the one before ended does not begin.
/// @param layers    as sliced
/// @param toolpath  their plan, in the same frame
std::size_t countStartsInAir(const std::vector<Layer>& layers, const std::vector<ToolpathLayer>& toolpath,
                             const BedPlane& bed, double bead_width_mm);

}  // namespace lamina
