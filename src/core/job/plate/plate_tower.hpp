// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/job/job_settings.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// A part that stands beside the tower.
struct TowerNeighbour {
  std::string name;
  const JobSettings* settings = nullptr;  ///< its own
};

/// Width of the area that the prime tower takes beside the parts, with its distance from them [mm]: enough
/// for as many tool changes as a layer may need. 0 if there is no tower, or if its position is set.
double roomForTower(const JobSettings& plate, const std::vector<TowerNeighbour>& parts);

/// Adds the prime tower of a plate that is deposited layer by layer, with the purges that `tools.*` asks for.
/// The tower belongs to no part. Travels to another tool and from layer to layer are made anew, without
/// wipes.
/// @param plate  sorted by tool within each layer, with part marks [bed frame]
/// @throws as `arrangeTools`
Toolpath withTower(Toolpath plate, const PlanSettings& settings);

}  // namespace lamina
