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

/// Regions of a part with their own settings of supports, and marks that force or forbid supports.
struct SupportRegions {
  const std::vector<PlanVariant>* variants = nullptr;  ///< null for none
  const SupportMarks* marks = nullptr;                 ///< null for none
};

/// The areas that need support.
struct RegionalOverhangs {
  std::vector<Regions> held;  ///< by layer
  double blocked_mm2 = 0.0;   ///< area of overhangs where marks forbid supports
};

/// The overhangs of a part (`overhangAreas`), with `supports.use`, `supports.angle_deg` and bridges of each
/// region. Where marks forbid supports there are none; where marks force them, all that is unsupported
/// counts.
/// @param layer_height_mm  for the measures of bridges
RegionalOverhangs regionalOverhangs(const StackedMaterial& stack, const PlanSettings& settings,
                                    const SupportRegions& regions, double layer_height_mm,
                                    Progress& progress);

}  // namespace lamina
