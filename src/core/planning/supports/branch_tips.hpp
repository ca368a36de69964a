// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/planning/supports/support_settings.hpp"
#include "planning/supports/support_areas.hpp"

namespace lamina {

/// The upper end of a branch.
struct BranchTip {
  Point2 at;
  std::size_t overhang = 0;  ///< layer that it holds up
  ColumnTop top;
};

/// Tips spread over what hangs over, on its rim first: every place of it lies within
/// `supports.tip_spacing_mm` of one, but where it is nearer to the part than a tip may be. Below ledges
/// (`ledgesIn`) tips follow the wall of each layer, as near to it as `ledgeGap`.
/// @param overhangs  of each layer
std::vector<BranchTip> branchTips(const StackedMaterial& stack, const std::vector<Regions>& overhangs,
                                  const WallBeads& walls, const SupportSettings& settings);

}  // namespace lamina
