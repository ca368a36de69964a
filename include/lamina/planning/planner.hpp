// SPDX-FileCopyrightText: 2026 The Lamina authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "lamina/base/progress.hpp"
#include "lamina/planning/plan_settings.hpp"
#include "lamina/slicing/layer.hpp"
#include "lamina/toolpath/toolpath.hpp"

namespace lamina {

/// The toolpath of a part cut into planar layers: skirt, walls and infill of each layer, ordered to shorten
/// travel and joined by travel paths. The nozzle points down; its tip runs at the top of each layer. Layers
/// whose section is empty stay in the toolpath without paths.
///
/// @param layers  ascending, in the part frame [mm]
/// @return satisfies `validate`; the same for any number of threads
/// @throws InvalidConfig if a setting is out of range or the strategy unknown; Cancelled
Toolpath planToolpath(const std::string& part_name, const std::vector<Layer>& layers,
                      const PlanSettings& settings, Progress& progress);

}  // namespace lamina
