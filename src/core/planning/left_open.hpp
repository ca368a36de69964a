// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/planning/left_open.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/layer_planner.hpp"

namespace lamina {

/// The area that a layer leaves open where a fill in cells is to be solid, in the plan or in a region with
/// its own settings; all 0 if there is no such fill. A bead counts for all the area that it covers.
/// @param planned  the layer, where it was sliced
LeftOpen leftOpenIn(const StackedLayer& stacked, const ToolpathLayer& planned, std::size_t index,
                    const PlanContext& context);

}  // namespace lamina
