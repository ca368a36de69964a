// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "lamina/planning/left_open.hpp"
#include "lamina/toolpath/toolpath.hpp"
#include "planning/layer_planner.hpp"

namespace lamina {

/// What a layer leaves open where it is to be solid and its fill lies in cells, be it by the settings of the
/// plan or by those of a region of their own; all 0 if that is nowhere. A bead counts for all that it covers.
/// @param planned  the layer, where it was sliced
LeftOpen leftOpenIn(const StackedLayer& stacked, const ToolpathLayer& planned, std::size_t index,
                    const PlanContext& context);

}  // namespace lamina
