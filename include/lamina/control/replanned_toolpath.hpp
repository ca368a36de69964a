// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "lamina/control/replanning.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The layers of a part that are left to lay, and the error of what is deposited.
struct LayersLeft {
  std::size_t first = 0;  ///< first layer that is not deposited
  /// Mean of planned less actual height of what lies below that layer: positive is too low.
  double error_mm = 0.0;
};

/// The part as the functions of `replanning.hpp` take it.
/// @param growth  gain learnt, actual over commanded growth; positive
/// @throws InvalidInput naming the layer: if none is left, or one is not as high as its distance from the one
///   below, is not plane, or deposits drops
PartUnderWay partUnderWay(const Toolpath& toolpath, const LayersLeft& left, double growth);

/// The layers left, at new heights. Paths are moved along the layers' normal; beads change in height as their
/// layer does, and have `flow` times the volume. The first layer lies on the actual surface, the last one
/// ends at the planned top. A new layer takes the paths of the planned layer at the same share of the height
/// left: on leaning walls its contours are those of a height up to half a layer off. Travels lead from layer
/// to layer as before, to the new heights.
///
/// @throws InvalidInput as `partUnderWay`, or naming the layer where no travel leads to the next one
Toolpath replannedToolpath(const Toolpath& toolpath, const LayersLeft& left, const NewHeights& heights);

/// The identity of a plan, which names its parent: that of the toolpath, `-from-`, the layer of the parent
/// that its first layer replaces, `-of-`, and the identity of the parent.
std::string replannedId(const Toolpath& replanned, std::size_t first_layer, const std::string& parent_id);

/// Whether a plan replaces the rest of that toolpath, which may be a plan itself.
bool isPlanOf(const std::string& plan_id, const std::string& toolpath_id);

/// The layer of the parent that the first layer of a plan replaces; nothing if the identity names none.
std::optional<std::size_t> firstLayerOf(const std::string& plan_id);

/// Why a machine that runs a toolpath cannot go over to a plan, in words; empty if it can.
///
/// @param awaited  layer before which the machine is held for its map; none if it is not held
std::string refusalOfPlan(const std::string& plan_id, const std::string& toolpath_id,
                          std::optional<std::size_t> awaited);

}  // namespace lamina
