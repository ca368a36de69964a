// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/plan_settings.hpp"

namespace lamina {

/// Settings that replace the plan's settings in regions of its layers.
///
/// A variant has its own number of walls, feeds, flow, tools, fill, skins, bridges and supports. Walls follow
/// the part's outline through all variants, and change feed, flow and tool where they cross from one to the
/// next. Where a variant has more walls than its neighbour, the additional inner walls end at the border
/// between the two. The fill of each variant ends at the border as at a wall. All other settings of walls
/// come from the plan; in an island wholly covered by variants, from the first of these variants. Settings of
/// whole layers (size of beads, travels, skirt, voids) always come from the plan.
struct PlanVariant {
  PlanSettings settings;
  std::vector<Regions> areas;  ///< by layer [frame of the layers]; variants do not overlap
};

}  // namespace lamina
