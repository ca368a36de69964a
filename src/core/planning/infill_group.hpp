// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "planning/skins/layer_cover.hpp"
#include "planning/skins/stack_covers.hpp"
#include "planning/walls/infill_spacing.hpp"

namespace lamina {

/// The group of `infill.every_layers` layers that a layer belongs to, from 0 at the bottom.
std::size_t groupOf(const InfillSettings& settings, std::size_t layer);

/// What is asked of a fill of that layer, but for where it is laid. Groups turn a sparse infill together.
InfillRequest requestOf(const PlanSettings& settings, const InfillSpacing& spacing, std::size_t layer);

/// What a layer has to know of its group.
struct InfillGroup {
  SharedRegions common;    ///< what is sparse in all layers of the group, with what runs into the walls
  bool is_last = false;    ///< in this layer the infill of the group is laid
  double height_mm = 0.0;  ///< of all layers of the group together
};

/// Infill of one layer, shared out.
struct GroupedInfill {
  Regions together;  ///< laid in beads as high as the group; none but in its last layer
  Regions alone;     ///< laid by the layer for itself, without what is narrower than a bead
};

/// @param area  of sparse infill in one layer
GroupedInfill groupedInfill(const Regions& area, const InfillGroup& group, double bead_width_mm);

/// The groups of a stack, for each layer its own. Those that are not complete at the top are groups all the
/// same. None if each layer has an infill of its own.
/// @param covers      of all layers
/// @param heights_mm  of all layers
/// @param place       where they lie
std::vector<InfillGroup> infillGroups(const std::vector<LayerCover>& covers,
                                      const std::vector<double>& heights_mm, const PlanSettings& settings,
                                      StackPlace place, Progress& progress);

/// The same elsewhere in the plane of the layers.
InfillGroup moved(const InfillGroup& group, const Point2& by);

}  // namespace lamina
