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

/// A branch where it passes a layer, or the lower layer in which it ends.
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
  std::vector<BranchTip> tips;  ///< that are held up
  std::size_t dropped = 0;      ///< tips whose branch found no foot
};

/// Branches from tips to bed or part, layer by layer from the top: each leans by at most
/// `supports.branch_angle_deg`, towards its nearest neighbour where both would meet above the bed, and keeps
/// `supports.side_gap_mm` from the part, or `ledgeGap` where it has no other way; those that meet go on as
/// one. It widens by `supports.branch_taper_deg` on each side with the way to its farthest tip, up to
/// `supports.branch_mm`, but where the part leaves no room. With `supports.foot: bed` branches keep out of
/// where the bed is out of reach.
/// @param tips  as of `branchTips`
SupportTree growBranches(const StackedMaterial& stack, std::vector<BranchTip> tips,
                         const SupportSettings& settings, Progress& progress);

}  // namespace lamina
