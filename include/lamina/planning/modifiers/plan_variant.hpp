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
/// border, where feeds change and fills meet as at a wall. The number of walls, the feeds and the fill are
/// the variant's own. All other settings of walls are the plan's; in an island that variants cover whole,
/// those of the first of them. Settings of whole layers (beads, travels, skirt, voids) are always the plan's.
struct PlanVariant {
  PlanSettings settings;
  std::vector<Regions> areas;  ///< by layer, [frame of the layers]; those of several variants lie apart
};

}  // namespace lamina
