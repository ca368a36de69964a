// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "lamina/control/replanning.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// Where a part stands that is printed otherwise than planned.
struct LayersLeft {
  std::size_t first = 0;  ///< layer that is not laid yet
  double error_mm =
      0.0;  ///< planned less actual height of what lies below it, in the mean: positive is too low
};

/// The part as planning anew sees it.
/// @param growth  learnt, over commanded growth; positive
/// @throws InvalidInput naming the layer: where none is left, one is not as high as it lies above the one
///   below, or is not plane, or deposits drops
PartUnderWay partUnderWay(const Toolpath& toolpath, const LayersLeft& left, double growth);

/// The layers left, at new heights: their paths, moved along the layers' normal to where the new heights have
/// them, with beads as much higher as the layer, and `flow` times the volume. They begin on what is laid, as
/// high as it is, and end at the planned top. A new layer takes the paths of the planned one that lies at its
/// share of what is left: on walls that lean, contours are those of up to half a layer beside it. Travels
/// lead from layer to layer as before, to the new heights.
///
/// @throws InvalidInput as `partUnderWay`, or naming the layer where no travel leads to the next one
Toolpath replannedToolpath(const Toolpath& toolpath, const LayersLeft& left, const NewHeights& heights);

/// An identity of its own that names its parent: that of the toolpath, `-from-`, the layer of the parent in
/// whose place its first one comes, `-of-`, and the parent's own.
std::string replannedId(const Toolpath& replanned, std::size_t first_layer, const std::string& parent_id);

/// Whether a plan takes the place of the rest of that toolpath, which may be a plan itself.
bool isPlanOf(const std::string& plan_id, const std::string& toolpath_id);

/// The layer of the parent in whose place a plan's first one comes; nothing if the identity names none.
std::optional<std::size_t> firstLayerOf(const std::string& plan_id);

/// Why a machine that runs a toolpath cannot go over to a plan, in words; empty if it can.
///
/// @param awaited  layer in front of which the machine is held for its map; none where it is held in front of
/// none
std::string refusalOfPlan(const std::string& plan_id, const std::string& toolpath_id,
                          std::optional<std::size_t> awaited);

}  // namespace lamina
