// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/plan_settings.hpp"

namespace lamina {

/// Settings that replace those of a plan in part of its layers.
///
/// A variant has its own number of walls, feeds and fill. Walls follow the part's outline. If a variant has
/// more walls than its neighbour, the inner ones end at its border, where feeds change and fills meet as at a
/// wall. All other settings of walls are the plan's, or those of the first variant in an island that variants
/// cover whole. Settings of whole layers (beads, travels, skirt, voids) are always the plan's.
struct PlanVariant {
  PlanSettings settings;
  std::vector<Regions> areas;  ///< by layer, [frame of the layers]; those of several variants lie apart
};

}  // namespace lamina
