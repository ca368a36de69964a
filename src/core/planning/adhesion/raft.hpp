// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/geometry/polygon/polygon.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/slicing/planar/layer_stack.hpp"
#include "planning/build_aids.hpp"

namespace lamina {

/// A layer below the part.
struct RaftLayer {
  LayerBounds bounds;
  LayerAids aids;
};

/// The area of a raft: the area standing on it, with gaps narrower than 10 mm closed, grown by the margin.
Regions raftArea(const Regions& standing, const RaftSettings& settings);

/// Layers of lines, each across the one below: a base and middle layers of lines two pitches apart, then
/// solid top layers. The uppermost layer ends `raft.gap_mm` below the part.
/// @param part_mm          height at which the part begins [frame of the layers]
/// @param layer_height_mm  of all layers but the base
/// @return from the bed up
std::vector<RaftLayer> makeRaft(const Regions& area, const PlanSettings& settings, double part_mm,
                                double layer_height_mm);

}  // namespace lamina
