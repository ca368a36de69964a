// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "planning/build_aids.hpp"
#include "planning/supports/support_tree.hpp"

namespace lamina {

/// Branches as loops: one, and a second one where they are thicker than 6 mm.
struct BranchLoops {
  std::vector<LayerAids> layers;  ///< as many as the part has
  std::vector<Regions> areas;     ///< what branches cover in each of them
};

/// @param taken  of the first layer: no branch lies there
BranchLoops branchLoops(const SupportTree& tree, const Regions& taken, const PlanSettings& settings,
                        Progress& progress);

/// What hangs over, in total and farther than `supports.tip_spacing_mm` from any tip that is held up, and the
/// largest section of branches.
SupportTotals branchTotals(const std::vector<Regions>& overhangs, const SupportTree& tree,
                           const BranchLoops& loops, const SupportSettings& settings);

}  // namespace lamina
