// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/planning/modifiers/plan_variant.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/planning/supports/support_marks.hpp"
#include "planning/supports/stacked_material.hpp"

namespace lamina {

/// Where regions of a part ask for supports of their own.
struct SupportRegions {
  const std::vector<PlanVariant>* variants = nullptr;  ///< null for none
  const SupportMarks* marks = nullptr;                 ///< null for none
};

/// What is to be held up in each layer, and what a mark forbids to.
struct RegionalOverhangs {
  std::vector<Regions> held;
  double blocked_mm2 = 0.0;  ///< overhangs that lie where supports never are
};

/// The overhangs of a part (`overhangAreas`), in regions by `supports.use`, `supports.angle_deg` and the
/// bridges of their own; without what lies where supports never are, and with all that lies over nothing
/// where they always are.
/// @param layer_height_mm  by which bridges are measured
RegionalOverhangs regionalOverhangs(const StackedMaterial& stack, const PlanSettings& settings,
                                    const SupportRegions& regions, double layer_height_mm,
                                    Progress& progress);

}  // namespace lamina
