// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "planning/build_aids.hpp"
#include "planning/supports/support_tree.hpp"

namespace lamina {

/// The loops of branches: one, and a second one where a branch is thicker than 6 mm.
struct BranchLoops {
  std::vector<LayerAids> layers;  ///< one per layer of the part
  std::vector<Regions> areas;     ///< area of branches in each layer
};

/// Makes the loops of a tree.
/// @param taken  area of the first layer in which no branch may lie
BranchLoops branchLoops(const SupportTree& tree, const Regions& taken, const PlanSettings& settings,
                        Progress& progress);

/// Totals of a tree: area of all overhangs, area of the overhangs farther than `supports.tip_spacing_mm` from
/// any supported tip, and the greatest area of branches in a layer.
SupportTotals branchTotals(const std::vector<Regions>& overhangs, const SupportTree& tree,
                           const BranchLoops& loops, const SupportSettings& settings);

}  // namespace lamina
