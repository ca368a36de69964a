// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/planning/skins/layer_cover.hpp"
#include "lamina/slicing/layer.hpp"

namespace lamina {

/// Where a stack of layers may lie.
enum class StackPlace {
  NearOrigin,
  AlongBelt,  ///< anywhere: its stretches are moved to the origin for planning (`distanceFromOrigin`)
};

/// The cover of each layer of a part (`coversOf`), at its place.
/// @throws as operations on regions beyond 10 m from the origin, unless the stack may lie anywhere
std::vector<LayerCover> stackCovers(const std::vector<Layer>& layers, const PlanSettings& settings,
                                    StackPlace place, Progress& progress);

}  // namespace lamina
