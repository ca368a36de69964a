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

/// What the tower takes beside the parts [mm], with its distance from them: as wide as most changes in a
/// layer may need. 0 without one, and where it has a place of its own.
double roomForTower(const JobSettings& plate, const std::vector<TowerNeighbour>& parts);

/// Adds the prime tower of a plate that is deposited layer by layer, with the purges that `tools.*` asks for;
/// it is of no part. Ways to another tool and from layer to layer are made anew, without wipes.
/// @param plate  tool by tool in each layer, with the marks of its parts [bed frame]
/// @throws as `arrangeTools`
Toolpath withTower(Toolpath plate, const PlanSettings& settings);

}  // namespace lamina
