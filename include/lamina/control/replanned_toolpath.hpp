// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "lamina/control/replanning.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The layers of a part that are still to be deposited, and the height error of the surface below them.
struct LayersLeft {
  std::size_t first = 0;  ///< first layer that is not deposited yet
  /// Mean of planned less actual height of the surface below that layer; positive if too low.
  double error_mm = 0.0;
};

/// The part in the form that the functions of `replanning.hpp` take.
/// @param growth  gain learnt, actual over commanded growth; positive
/// @throws InvalidInput if no layer is left; naming the layer, if its height differs from its distance from
///   the one below, it is not plane, or it deposits drops
PartUnderWay partUnderWay(const Toolpath& toolpath, const LayersLeft& left, double growth);

/// The layers left, at new heights. The first one lies on the actual surface, each other one on the layer
/// below it. Paths are moved along the layers' normal. The height of their beads changes by the same factor
/// as that of the layer, and beads have `flow` times the volume. A new layer has the paths of the planned
/// layer at the same share of the number of layers left; on inclined walls its contours may therefore be
/// those of up to half a layer higher or lower. Travels from layer to layer lead to the new heights.
///
/// @throws InvalidInput as `partUnderWay`; naming the new layer if no travel leads to it
Toolpath replannedToolpath(const Toolpath& toolpath, const LayersLeft& left, const NewHeights& heights);

/// The identity of a plan: that of its toolpath, `-from-`, the number of the parent's layer that its first
/// layer replaces, `-of-`, and the identity of the parent. If the parent is a plan too, only its own part of
/// the identity is named.
std::string replannedId(const Toolpath& replanned, std::size_t first_layer, const std::string& parent_id);

/// Whether a plan replaces the rest of a toolpath. That toolpath may be a plan itself.
bool isPlanOf(const std::string& plan_id, const std::string& toolpath_id);

/// The number of the parent's layer that the first layer of a plan replaces; nothing if the identity states
/// none.
std::optional<std::size_t> firstLayerOf(const std::string& plan_id);

/// The reason why a machine that runs a toolpath cannot change to a plan, in words; empty if it can.
///
/// @param awaited  layer before which the machine is waiting for a map; none if it is not waiting
std::string refusalOfPlan(const std::string& plan_id, const std::string& toolpath_id,
                          std::optional<std::size_t> awaited);

}  // namespace lamina
