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
  std::size_t overhang = 0;  ///< layer that it supports
  ColumnTop top;
};

/// Tips spread over the overhangs, along their rims first. Every place of an overhang is within
/// `supports.tip_spacing_mm` of a tip, except places too near to the part for a tip. Below ledges
/// (`ledgesIn`) tips follow the wall of each layer at the distance `ledgeGap`.
/// @param overhangs  of each layer
std::vector<BranchTip> branchTips(const StackedMaterial& stack, const std::vector<Regions>& overhangs,
                                  const WallBeads& walls, const SupportSettings& settings);

}  // namespace lamina
