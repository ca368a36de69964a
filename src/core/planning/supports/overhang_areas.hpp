// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/planning/bridges/bridge_direction.hpp"
#include "lamina/planning/supports/support_settings.hpp"
#include "planning/supports/stacked_material.hpp"

namespace lamina {

/// The overhang of a layer: pieces beyond the layer below that extend farther than `lean_mm` from it, each up
/// to the wall on which it hangs.
Regions overhangOf(const Regions& layer, const Regions& below, double lean_mm);

/// The part of an overhang that needs support: without areas that are held otherwise, as by bridges.
/// @param held  area of the same layer that is held; may be empty
Regions toHoldUp(const Regions& overhang, const Regions& held);

/// Bridges that need no support.
struct HoldingBridges {
  BridgeSearch search;
  double longest_mm = 0.0;  ///< longer free spans need support; 0 for no limit
};

/// The pieces of an overhang that bridges span: threads held at both ends make up at least `least_held` of
/// the length of all threads in the piece.
Regions heldByBridges(const Regions& overhang, const Regions& below, const HoldingBridges& bridges);

/// The area that needs support in each layer: overhangs beyond `supports.angle_deg`, and a disc of
/// `supports.tip_mm` round each isolated place that is too small for a support. The first layer has none. In
/// inclined layers the bed supports like material.
/// @param bridges  none if bridges need support too
/// @return one per layer; a layer that equals the one below has none, and costs nothing
std::vector<Regions> overhangAreas(const StackedMaterial& stack, const SupportSettings& settings,
                                   Progress& progress,
                                   const std::optional<HoldingBridges>& bridges = std::nullopt);

}  // namespace lamina
