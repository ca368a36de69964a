// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/plan_settings.hpp"

namespace lamina {

/// Settings of a plan that hold in part of its layers instead of those of the plan.
///
/// Walls follow the part's outline; where a variant has more than its neighbour, the inner ones end at its
/// border, where feeds change and fills meet as at a wall. What else walls take is of the plan, in an island
/// of variants alone of the first one; what is of whole layers (beads, travels, skirt, voids) is of the plan.
struct PlanVariant {
  PlanSettings settings;
  std::vector<Regions> areas;  ///< by layer, [frame of the layers]; those of several variants lie apart
};

}  // namespace lamina
