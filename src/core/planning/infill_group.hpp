// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/infill/strategy.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/planning/skins/layer_cover.hpp"
#include "planning/skins/stack_covers.hpp"
#include "planning/walls/infill_spacing.hpp"

namespace lamina {

/// Number of the group of `infill.every_layers` layers to which a layer belongs, from 0 at the bottom.
std::size_t groupOf(const InfillSettings& settings, std::size_t layer);

/// The request for a fill of that layer, except its area. The layers of a group have the same direction of
/// sparse infill.
InfillRequest requestOf(const PlanSettings& settings, const InfillSpacing& spacing, std::size_t layer);

/// The group of a layer. Its common infill is deposited in its last layer.
struct InfillGroup {
  SharedRegions common;    ///< area of sparse infill in all layers of the group, overlap with walls included
  bool is_last = false;    ///< this layer is the last one of the group
  double height_mm = 0.0;  ///< sum over the layers of the group
};

/// The sparse infill of one layer, divided.
struct GroupedInfill {
  Regions together;  ///< deposited in beads as high as the group; empty except in its last layer
  Regions alone;     ///< deposited in this layer alone, without places narrower than a bead
};

/// Divides an area of sparse infill in one layer.
/// @param area  area of sparse infill in the layer
GroupedInfill groupedInfill(const Regions& area, const InfillGroup& group, double bead_width_mm);

/// The group of each layer of a stack. An incomplete group at the top counts too. Empty if each layer has an
/// infill of its own.
/// @param covers      of all layers
/// @param heights_mm  of all layers
/// @param place       where the layers may lie
std::vector<InfillGroup> infillGroups(const std::vector<LayerCover>& covers,
                                      const std::vector<double>& heights_mm, const PlanSettings& settings,
                                      StackPlace place, Progress& progress);

/// The group, moved in the plane of the layers [mm].
InfillGroup moved(const InfillGroup& group, const Point2& by);

}  // namespace lamina
