// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/slicing/layer.hpp"
#include "planning/skins/layer_cover.hpp"

namespace lamina {

/// Where a stack of layers may lie.
enum class StackPlace {
  NearOrigin,
  AlongBelt,  ///< anywhere: stretches of it are looked at near the origin (`distanceFromOrigin`)
};

/// What covers each layer of a part (`coversOf`), where the layers are.
/// @throws what regions do that lie farther than 10 m from the origin, unless the stack may lie anywhere
std::vector<LayerCover> stackCovers(const std::vector<Layer>& layers, const PlanSettings& settings,
                                    StackPlace place, Progress& progress);

}  // namespace lamina
