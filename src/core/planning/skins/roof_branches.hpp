// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/planning/skins/layer_cover.hpp"
#include "planning/skins/stack_covers.hpp"

namespace lamina {

/// Branches in each layer that support the skins of the layers above (`branchesUnderRoofs`). Skins here are
/// solid areas over the infill, between the walls.
/// @param covers      of each layer, from the bottom
/// @param heights_mm  of each layer
/// @param place       where the layers may lie
/// @return one per layer; the same for any number of threads
std::vector<std::vector<Polyline>> branchesUnderSkins(const std::vector<LayerCover>& covers,
                                                      const std::vector<double>& heights_mm,
                                                      const PlanSettings& settings, StackPlace place,
                                                      Progress& progress);

}  // namespace lamina
