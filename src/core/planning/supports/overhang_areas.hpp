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

/// What of a layer hangs over the one below: pieces of what is not above that in which it goes farther than
/// `lean_mm`, up to the wall that they hang on.
Regions overhangOf(const Regions& layer, const Regions& below, double lean_mm);

/// What of an overhang supports must hold up: not what is held otherwise, such as by bridges.
/// @param held  of the same layer; nothing if all of it hangs
Regions toHoldUp(const Regions& overhang, const Regions& held);

/// Bridges that need no support.
struct HoldingBridges {
  BridgeSearch search;
  double longest_mm = 0.0;  ///< longer free spans are held up all the same; 0 for no limit
};

/// The pieces of an overhang that bridges span: threads are held at both ends over most of their length.
Regions heldByBridges(const Regions& overhang, const Regions& below, const HoldingBridges& bridges);

/// What supports must hold up in each layer: overhangs beyond `supports.angle_deg`, and a disc of
/// `supports.tip_mm` round each place too small for a support that hangs without any material below it. The
/// first layer has none; bed that shows in inclined layers carries like material.
/// @param bridges  none if what they span is held up too
/// @return as many as layers; those that equal the layer below have none, and cost nothing
std::vector<Regions> overhangAreas(const StackedMaterial& stack, const SupportSettings& settings,
                                   Progress& progress,
                                   const std::optional<HoldingBridges>& bridges = std::nullopt);

}  // namespace lamina
