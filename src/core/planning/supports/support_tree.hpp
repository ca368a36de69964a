// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/planning/supports/support_settings.hpp"
#include "planning/supports/branch_tips.hpp"
#include "planning/supports/support_areas.hpp"

namespace lamina {

/// The cross-section of a branch in a layer, or in the lower layer in which it ends.
struct BranchDisc {
  Point2 at;
  double radius_mm = 0.0;
  double bottom_mm = 0.0;
  double top_mm = 0.0;
  std::size_t branch = 0;  ///< index of the tip that it leads to
};

/// Branches of level layers.
struct SupportTree {
  std::vector<std::vector<BranchDisc>> layers;
  std::vector<BranchTip> tips;  ///< those that are supported
  std::size_t dropped = 0;      ///< number of tips whose branch cannot reach the ground
};

/// Grows branches from tips down to bed or part, layer by layer. A branch leans by at most
/// `supports.branch_angle_deg`, towards its nearest neighbour if both can meet above the bed; branches that
/// meet continue as one. It keeps `supports.side_gap_mm` from the part, or only `ledgeGap` if it cannot pass
/// otherwise. It widens by `supports.branch_taper_deg` on each side with the length to its farthest tip, up
/// to `supports.branch_mm`, as far as the part leaves room. With `supports.foot: bed` branches avoid places
/// from which the bed cannot be reached.
/// @param tips  those of `branchTips`
SupportTree growBranches(const StackedMaterial& stack, std::vector<BranchTip> tips,
                         const SupportSettings& settings, Progress& progress);

}  // namespace lamina
