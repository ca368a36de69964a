// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/plan_settings.hpp"

namespace lamina {

/// Settings of a plan that hold in part of its layers instead of those of the plan.
///
/// Walls follow the outline of the part only. Where a variant has more of them than what is beside it, the
/// inner ones end at its border. Fills and skins of areas that meet do so as at a wall. Feeds of walls change
/// on the border. Beads, travels, skirt, voids and what else is of a whole layer stays that of the plan.
struct PlanVariant {
  PlanSettings settings;
  std::vector<Regions> areas;  ///< by layer, [frame of the layers]; those of several variants lie apart
};

}  // namespace lamina
